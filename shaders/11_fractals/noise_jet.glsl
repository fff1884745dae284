// Noise with its first and second derivatives.
#include "11_fractals/lattice.glsl"
#include "11_fractals/noise_derivative.glsl"

struct NoiseJet {
    float value;
    vec2 gradient;
    mat2 hessian;  // the gradient's own derivatives, by columns
};

// Weights of the lower and the upper corner along one axis, and their first and second derivatives, by columns.
mat3x2 corner_weights(float t) {
    float left = 1.0 - t, upper = t * t * t * (10.0 + t * (6.0 * t - 15.0));
    float first = 30.0 * t * t * left * left, second = 60.0 * t * left * (1.0 - 2.0 * t);
    return mat3x2(1.0 - upper, upper, -first, first, -second, second);
}

// At a position in a cell, `f` 0 to 1. The noise is x * corners * y, with the weights along both axes; only one of the two
// depends on each coordinate.
NoiseJet noise_jet(ivec2 cell, vec2 f) {
    vec3 first = noise_derivative(cell, f);
    mat2 corners;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) corners[y][x] = lattice(cell + ivec2(x, y));
    mat3x2 x = corner_weights(f.x), y = corner_weights(f.y);
    float across = dot(x[1], corners * y[1]);
    return NoiseJet(first.x, first.yz, mat2(dot(x[2], corners * y[0]), across, across, dot(x[0], corners * y[2])));
}
