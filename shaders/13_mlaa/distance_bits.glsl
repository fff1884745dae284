// What a pixel holds of the edges below it and on its right: for how many pixels the line of edges below goes on to the left and
// to the right, and that on the right up and down, the pixel itself counted: four bytes, 0 where there is no such edge.
const uint back_below = 0u, ahead_below = 8u, back_right = 16u, ahead_right = 24u;
const uint seed_of_below = 1u << back_below | 1u << ahead_below;
const uint seed_of_right = 1u << back_right | 1u << ahead_right;
uint byte_of(uint word, uint shift) { return word >> shift & 255u; }

uniform usampler2D distances;

uint distances_at(ivec2 pixel) {
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(distances, 0)));
    return inside ? texelFetch(distances, pixel, 0).x : 0u;
}
// Between the pixel and the one below it, or on its right. None outside of the picture.
bool edge_below(ivec2 pixel) { return byte_of(distances_at(pixel), back_below) > 0u; }
bool edge_right(ivec2 pixel) { return byte_of(distances_at(pixel), back_right) > 0u; }
