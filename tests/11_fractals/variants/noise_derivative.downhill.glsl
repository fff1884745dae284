// wrong: noise_derivative(
#include "11_fractals/lattice.glsl"

vec3 noise_derivative(ivec2 cell, vec2 f) {
    float a = lattice(cell), b = lattice(cell + ivec2(1, 0)), c = lattice(cell + ivec2(0, 1));
    float twist = a - b - c + lattice(cell + ivec2(1, 1));
    vec2 s = f * f * f * (f * (6.0 * f - 15.0) + 10.0), slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    return vec3(a + (b - a) * s.x + (c - a) * s.y + twist * s.x * s.y,
                -slope * (vec2(b, c) - a + twist * s.yx));
}
