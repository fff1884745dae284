// For the check of 13.line_ends: edges by lot.
#pragma replaces "13_mlaa/edge_words.glsl"

bool check_known_edge(ivec2 pixel, uint which) {
    uint n = uint(pixel.x + 64) * 73856093u ^ uint(pixel.y + 64) * 19349663u ^ which * 83492791u;
    n = (n ^ n >> 13) * 0x5bd1e995u;
    return ((n ^ n >> 15) & 256u) != 0u;
}
bool edge_below(ivec2 pixel) { return check_known_edge(pixel, 0u); }
bool edge_right(ivec2 pixel) { return check_known_edge(pixel, 1u); }
