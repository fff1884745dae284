// right, in its pictures too
#include "11_fractals/lattice.glsl"

float quintic_noise(ivec2 cell, vec2 f) {
    vec2 s = 6.0 * f * f * f * f * f - 15.0 * f * f * f * f + 10.0 * f * f * f;
    float lower = mix(lattice(cell), lattice(cell + ivec2(1, 0)), s.x);
    float upper = mix(lattice(cell + ivec2(0, 1)), lattice(cell + ivec2(1, 1)), s.x);
    return mix(lower, upper, s.y);
}
