// Exercise 11.noise_derivative: the slope of noise, from the numbers that its height comes from.
// Until you fill it in, the ground is level.
#include "11_fractals/lattice.glsl"

// [noise_derivative]
// (height, its derivative by f.x, its derivative by f.y): the height as in 11.quintic_noise, with s(t) = 6 t⁵ - 15 t⁴ + 10 t³,
// and the derivatives exactly, not by differences. The four numbers at the corners, each read once, are enough: write the
// height as a + (b - a) s(f.x) + (c - a) s(f.y) + (a - b - c + d) s(f.x) s(f.y).
// [/noise_derivative]
vec3 noise_derivative(ivec2 cell, vec2 f) {
    return vec3(lattice(cell), 0.0, 0.0);
}
