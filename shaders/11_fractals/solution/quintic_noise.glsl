// Solution of 11.quintic_noise (K. Perlin, Improving noise, 2002: the quintic).
#include "11_fractals/lattice.glsl"

float quintic_noise(ivec2 cell, vec2 f) {
    vec2 s = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float lower = mix(lattice(cell), lattice(cell + ivec2(1, 0)), s.x);
    float upper = mix(lattice(cell + ivec2(0, 1)), lattice(cell + ivec2(1, 1)), s.x);
    return mix(lower, upper, s.y);
}
