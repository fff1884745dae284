// Exercise 13.line_ends: an edge runs on whole pixels; where it turns says how the outline really runs.
// Until you fill it in, no edge turns, and every step of a staircase stays.
#include "13_mlaa/edge_source.glsl"

// [line_ends]
// A line of edges without a gap: below all pixels from `first` to `last` (the same row, first on the left), or, where
// `horizontal` is false, on the right of all of them (the same column, first on top). At each of its two ends, which are
// corners of pixels, edges across it may begin: one on the line's near side (above a horizontal line, left of a vertical
// one), one on its far side. And the next edge of the line itself may be there, behind the corner. Returns for the end at
// `first`, then for that at `last`, to which side the outline turns, -1 near, 1 far, 0 not at all:
// - the next edge is not there: to the side on which there is an edge across. Neither or both: 0.
// - it is, and not both edges across are: 0. The line was not followed farther.
// - it is, and so are both: two things touch with their corners. Their outlines do not cross: this one leaves to the side
//   that its other end does not turn to. 0 where that is 0, or such a corner too.
// edge_below(pixel) and edge_right(pixel) say whether there is an edge between a pixel and the one below it, or the one on
// its right. y grows downwards.
// [/line_ends]
ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    return ivec2(0);
}
