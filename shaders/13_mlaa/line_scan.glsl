// How far a line goes on from a pixel, sixteen pixels a read: it ends at the first bit that a missing edge or a crossing sets.
#include "13_mlaa/edge_words.glsl"

// [line_scan]
// Bit j: an edge is missing at pixel j of the word, and: all four edges meet behind pixel j, where lines are cut.
struct LineBreaks {
    uint missing, crossing;
};
LineBreaks line_breaks(int tile, int line, bool horizontal) {
    uint word = edge_word(tile, line, horizontal), across = edge_word(tile, line + 1, horizontal);
    return LineBreaks(~word & 0xffffu, (word & across) >> 16);
}

// Pixels from `at` to the end of its line, itself counted; at most `reach`. `found` is the word that holds it.
int scan_ahead(LineBreaks found, int at, int line, bool horizontal, int reach) {
    int from = (at & 15) + 1;  // of the word's pixels
    for (int tile = at >> 4;; from = 0) {
        uint ends = (found.missing | found.crossing << 1) >> from;  // before pixel j; 16 is the next word's first
        if (ends != 0u) return min(word_pixels * tile + from + findLSB(ends) - at, reach);
        if (word_pixels * (tile + 1) - at >= reach) return reach;
        found = line_breaks(++tile, line, horizontal);
    }
}

int scan_back(LineBreaks found, int at, int line, bool horizontal, int reach) {
    int before = at & 15;  // so many of the word's pixels
    for (int tile = at >> 4;; before = word_pixels) {
        uint ends = (found.missing | found.crossing) & (1u << before) - 1u;  // behind pixel j
        if (ends != 0u) return min(at - word_pixels * tile - findMSB(ends), reach);
        if (at - word_pixels * tile + 1 >= reach) return reach;
        found = line_breaks(--tile, line, horizontal);
    }
}
// [/line_scan]
