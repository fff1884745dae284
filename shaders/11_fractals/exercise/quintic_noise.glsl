// Exercise 11.quintic_noise: a smooth height between the numbers at the corners of a grid.
// Starter: each cell is flat.
#include "11_fractals/lattice.glsl"

// [quintic_noise]
// Returns the height at a point of a cell. `f`, 0 to 1 in x and y, is its position from
// the first corner of the cell. At the corners the height is lattice(cell),
// lattice(cell + ivec2(1, 0)), lattice(cell + ivec2(0, 1)) and lattice(cell + ivec2(1,
// 1)). In between, it is interpolated along x with the weight s(f.x) and along y with
// s(f.y).
//
// s rises from 0 to 1, and neither the slope nor the curvature of the ground may jump
// at the border of two cells: the first and second derivative of s are 0 at 0 and at 1.
// smoothstep, 3 t^2 - 2 t^3, has a second derivative that jumps, which the lighting
// reveals as lines. Find the polynomial of degree five that meets all six conditions.
// [/quintic_noise]
float quintic_noise(ivec2 cell, vec2 f) {
    return lattice(cell);
}
