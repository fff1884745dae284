// For 13.line_ends: where edges are.
#include "13_mlaa/distance_bits.glsl"

// The edges across that stand before and after the edge below a pixel, where a staircase falls to the right (`way` 1) or
// to the left (-1).
bool edge_before(ivec2 pixel, int way) { return edge_right(way > 0 ? pixel - ivec2(1, 0) : pixel); }
bool edge_after(ivec2 pixel, int way) { return edge_before(pixel + ivec2(way, 1), way); }
