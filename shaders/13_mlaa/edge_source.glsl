// For 13.line_ends: where edges are.
#include "13_mlaa/edge_words.glsl"

// The edges across that stand before and after the edge below a pixel, where a staircase falls to the right (`way` 1) or
// to the left (-1).
bool edge_before(ivec2 pixel, int way) { return edge_right(way > 0 ? pixel - ivec2(1, 0) : pixel); }
bool edge_after(ivec2 pixel, int way) { return edge_before(pixel + ivec2(way, 1), way); }

// A step of a staircase is an edge below a pixel with an edge across before or after it. Does the one before or after
// it follow directly? (Both edges are always read: neither read waits for the other.)
bool is_step(ivec2 pixel, int way) { return edge_below(pixel) && (edge_before(pixel, way) || edge_after(pixel, way)); }
bool follows_before(ivec2 pixel, int way) { return (uint(edge_before(pixel, way)) & uint(edge_below(pixel - ivec2(way, 1)))) != 0u; }
bool follows_after(ivec2 pixel, int way) { return (uint(edge_after(pixel, way)) & uint(edge_below(pixel + ivec2(way, 1)))) != 0u; }
