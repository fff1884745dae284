// For 13.propagate_distance: distances known so far along one direction.
#include "13_mlaa/distance_bits.glsl"

uniform usampler2D from;
ivec2 known_from, known_direction;
uint known_shift;

// For how many pixels the line goes on beyond the one that lies so many steps ahead, as far as was found by now.
uint known(uint steps) {
    ivec2 pixel = known_from + int(steps) * known_direction;
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(from, 0)));
    return inside ? max(byte_of(texelFetch(from, pixel, 0).x, known_shift), 1u) - 1u : 0u;
}
