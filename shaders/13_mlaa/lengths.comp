// How long lines and staircases are, without passes that double: lines from words of edges, staircases step by step.
#define WORK_ACCESS readonly
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/edge_words.glsl"
#include "13_mlaa/work.glsl"

// How far a line goes on from a pixel, sixteen pixels a read: it ends at the first bit that a missing edge or a crossing sets.

// [line_scan]
// Bit j: an edge is missing at pixel j of the word, and: all four edges meet behind pixel j, where lines are cut.
struct LineBreaks {
    uint missing, crossing;
};
LineBreaks line_breaks(int tile, int line, bool horizontal) {
    uint word = edge_word(tile, line, horizontal), across = edge_word(tile, line + 1, horizontal);
    return LineBreaks(~word & 0xffffu, (word & across) >> 16);
}

// Pixels from `at` to the end of its line, itself counted; at most `reach`.
uint scan_ahead(int at, int line, bool horizontal, int reach) {
    int from = (at & 15) + 1;  // of the word's pixels
    for (int tile = at >> 4;; ++tile, from = 0) {
        LineBreaks found = line_breaks(tile, line, horizontal);
        uint ends = (found.missing | found.crossing << 1) >> from;  // before pixel j; 16 is the next word's first
        if (ends != 0u) return uint(min(word_pixels * tile + from + findLSB(ends) - at, reach));
        if (word_pixels * (tile + 1) - at >= reach) return uint(reach);
    }
}

uint scan_back(int at, int line, bool horizontal, int reach) {
    int before = at & 15;  // so many of the word's pixels
    for (int tile = at >> 4;; --tile, before = word_pixels) {
        LineBreaks found = line_breaks(tile, line, horizontal);
        uint ends = (found.missing | found.crossing) & (1u << before) - 1u;  // behind pixel j
        if (ends != 0u) return uint(min(at - word_pixels * tile - findMSB(ends), reach));
        if (at - word_pixels * tile + 1 >= reach) return uint(reach);
    }
}
// [/line_scan]

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(scalar) uniform MlaaBlock { int reach; } mlaa;
layout(r32ui) writeonly uniform uimage2D lengths;

uint scanned(int at, int line, bool horizontal) {
    return scan_back(at, line, horizontal, mlaa.reach) | scan_ahead(at, line, horizontal, mlaa.reach) << 8;
}

#ifdef DIAGONALS
layout(r32ui) writeonly uniform uimage2D staircases;

// Steps of a staircase from a pixel's on, itself counted, where `ahead` is 1 downwards and -1 upwards. Four are asked at once:
// none of these reads waits for another.
const uint asked = 4u;
uint walked(ivec2 pixel, int way, int ahead, uint reach) {
    for (uint steps = 1u; steps < reach; steps += asked) {
        uint ends = 1u << asked;
        for (uint k = 0u; k < asked; ++k) {
            ivec2 at = pixel + int(steps + k - 1u) * ahead * ivec2(way, 1);
            ends |= uint(!(ahead > 0 ? follows_after(at, way) : follows_before(at, way))) << k;
        }
        uint more = uint(findLSB(ends));
        if (more < asked) return min(steps + more, reach);
    }
    return reach;
}

uint staircase(ivec2 pixel, int way) {
    if (!is_step(pixel, way)) return 0u;
    return walked(pixel, way, -1, uint(mlaa.reach)) | walked(pixel, way, 1, uint(mlaa.reach)) << 8;
}
#endif

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        uint word = 0u;
        if (edge_below(pixel)) word |= scanned(pixel.x, pixel.y, true) << back_below;
        if (edge_right(pixel)) word |= scanned(pixel.y, pixel.x, false) << back_right;
        imageStore(lengths, pixel, uvec4(word));
#ifdef DIAGONALS
        imageStore(staircases, pixel, uvec4(staircase(pixel, 1) << back_falling | staircase(pixel, -1) << back_rising));
#endif
    }
}
