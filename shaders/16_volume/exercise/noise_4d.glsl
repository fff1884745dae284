// Exercise 16.noise_4d: noise over space and time.
// As it stands each cell has one number, and the noise has steps.
#include "16_volume/lattice_4d.glsl"

// [noise_4d]
// Value noise: lattice_4d() gives a number to each of the 16 corners of the cell, cell + (0 or 1, 0 or 1, 0 or 1, 0 or 1),
// and what lies between is mixed from them. `f` is the place in the cell, each component from 0 to 1; the weight of the
// upper corner along an axis is s(t) = 6 t⁵ - 15 t⁴ + 10 t³ with t = the component of f, that of the lower one 1 - s(t).
// The cell of whole numbers keeps the fourth axis, time, exact: after a week at a cell a second it is 604,800, and f is as
// fine as in the first second.
// [/noise_4d]
float noise_4d(ivec4 cell, vec4 f) {
    return lattice_4d(cell);
}
