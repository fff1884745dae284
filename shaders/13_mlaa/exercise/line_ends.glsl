// Exercise 13.line_ends: an edge runs on whole pixels; where it turns says how the outline really runs.
// Until you fill it in, no edge turns, and every step of a staircase stays.
#include "13_mlaa/edge_source.glsl"

// [line_ends]
// A line of edges without a gap: below all pixels from `first` to `last` (the same row, first on the left), or, where
// `horizontal` is false, on the right of all of them (the same column, first on top). At each of its two ends, which are
// corners of pixels, edges across it may begin: one on the line's near side (above a horizontal line, left of a vertical
// one), one on its far side. Returns for the end at `first`, then for that at `last`: -1 where there is an edge across on
// the near side alone, 1 on the far side alone, and 0 where there is neither, where there are both (four colours meet: no
// telling which belong together), and where the line itself goes on behind that end (it was not followed farther).
// edge_below(pixel) and edge_right(pixel) say whether there is an edge between a pixel and the one below it, or the one on
// its right. y grows downwards.
// [/line_ends]
ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    return ivec2(0);
}
