// Exercise 13.line_ends: the side to which the silhouette turns at the ends of a line.
// Starter: no line turns, and every staircase stays.
#include "13_mlaa/edge_source.glsl"

// [line_ends]
// A line is an uninterrupted sequence of edges. If `horizontal` is true, it lies below
// all pixels from `first` to `last`: the same row, first on the left. Otherwise it lies
// on the right of all of them: the same column, first at the top. y grows downwards.
// The near side of the line is the side of these pixels (above a horizontal line, left
// of a vertical one); the far side is the other one.
//
// Each end of the line is a corner of pixels, where up to three further edges meet it:
// a crossing edge on the near side, a crossing edge on the far side, and the
// continuation of the line itself.
//
// Returns, for the end at `first` (x) and for the end at `last` (y), the side to which
// the silhouette turns: -1 near, 1 far, 0 not at all.
// - No continuation: the side that has a crossing edge; 0 if both or neither have one.
// - A continuation, but not both crossing edges: 0. The line was merely not followed
//   any farther.
// - A continuation and both crossing edges: two shapes touch at this corner, and their
//   silhouettes do not cross. The silhouette turns to the side opposite to the one to
//   which it turns at the other end; 0 if it does not turn there, or if the other end
//   is such a corner, too.
//
// edge_below(pixel) and edge_right(pixel) return whether there is an edge between a
// pixel and the one below it, or the one on its right.
// [/line_ends]
ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    return ivec2(0);
}
