// Noise with its first and second derivatives.
#include "11_fractals/lattice.glsl"
#include "11_fractals/noise_derivative.glsl"

struct NoiseJet {
    float value;
    vec2 gradient;
    mat2 hessian;  // the gradient's own derivatives, by columns
};

// At a place of a cell, `f` 0 to 1.
NoiseJet noise_jet(ivec2 cell, vec2 f) {
    vec3 first = noise_derivative(cell, f);
    float a = lattice(cell), b = lattice(cell + ivec2(1, 0)), c = lattice(cell + ivec2(0, 1));
    float twist = a - b - c + lattice(cell + ivec2(1, 1));
    vec2 s = f * f * f * (f * (6.0 * f - 15.0) + 10.0), slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    vec2 bend = 60.0 * f * (f * (2.0 * f - 3.0) + 1.0) * (vec2(b, c) - a + twist * s.yx);
    float across = twist * slope.x * slope.y;
    return NoiseJet(first.x, first.yz, mat2(bend.x, across, across, bend.y));
}
