// right, in its pictures too
#include "11_fractals/lattice.glsl"

vec3 noise_derivative(ivec2 cell, vec2 f) {
    float a = lattice(cell), b = lattice(cell + ivec2(1, 0)), c = lattice(cell + ivec2(0, 1)), d = lattice(cell + 1);
    float sx = f.x * f.x * f.x * (f.x * (6.0 * f.x - 15.0) + 10.0), sy = f.y * f.y * f.y * (f.y * (6.0 * f.y - 15.0) + 10.0);
    float kx = 30.0 * f.x * f.x * (1.0 - f.x) * (1.0 - f.x), ky = 30.0 * f.y * f.y * (1.0 - f.y) * (1.0 - f.y);
    return vec3(mix(mix(a, b, sx), mix(c, d, sx), sy), kx * mix(b - a, d - c, sy), ky * mix(c - a, d - b, sx));
}
