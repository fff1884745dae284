// For 13.line_ends: where edges are.
#include "13_mlaa/distance_bits.glsl"

#ifdef KNOWN_EDGES
// For checks: edges by lot.
bool known_edge(ivec2 pixel, uint which) {
    uint n = uint(pixel.x + 64) * 73856093u ^ uint(pixel.y + 64) * 19349663u ^ which * 83492791u;
    n = (n ^ n >> 13) * 0x5bd1e995u;
    return ((n ^ n >> 15) & 256u) != 0u;
}
bool edge_below(ivec2 pixel) { return known_edge(pixel, 0u); }
bool edge_right(ivec2 pixel) { return known_edge(pixel, 1u); }
#else
uniform usampler2D distances;

uint distances_at(ivec2 pixel) {
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(distances, 0)));
    return inside ? texelFetch(distances, pixel, 0).x : 0u;
}
// Between the pixel and the one below it, or on its right. None outside of the picture.
bool edge_below(ivec2 pixel) { return byte_of(distances_at(pixel), back_below) > 0u; }
bool edge_right(ivec2 pixel) { return byte_of(distances_at(pixel), back_right) > 0u; }
#endif

// The edges across that stand before and after the edge below a pixel, where a staircase falls to the right (`way` 1) or
// to the left (-1).
bool edge_before(ivec2 pixel, int way) { return edge_right(way > 0 ? pixel - ivec2(1, 0) : pixel); }
bool edge_after(ivec2 pixel, int way) { return edge_before(pixel + ivec2(way, 1), way); }
