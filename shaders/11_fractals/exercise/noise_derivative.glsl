// Exercise 11.noise_derivative: the slope of the noise, from the same numbers as its height.
// Starter: the ground is level.
#include "11_fractals/lattice.glsl"

// [noise_derivative]
// Returns (height, its derivative by f.x, its derivative by f.y). The height is that of
// 11.quintic_noise, with s(t) = 6 t^5 - 15 t^4 + 10 t^3. The derivatives are exact, not
// differences. The four numbers at the corners are enough for all three: a at (0, 0), b at
// (1, 0), c at (0, 1), d at (1, 1). It helps to write the height as a + (b - a) s(f.x)
// + (c - a) s(f.y) + (a - b - c + d) s(f.x) s(f.y).
// [/noise_derivative]
vec3 noise_derivative(ivec2 cell, vec2 f) {
    return vec3(lattice(cell), 0.0, 0.0);
}
