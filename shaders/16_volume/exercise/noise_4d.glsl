// Exercise 16.noise_4d: noise over space and time.
// Starter: each cell has one number, and the noise has steps.
#include "16_volume/lattice_4d.glsl"

// [noise_4d]
// Value noise in four dimensions. lattice_4d(corner) returns the random number of a corner
// of the lattice. The cell has 16 corners, cell + (0 or 1, 0 or 1, 0 or 1, 0 or 1). `f` is
// the position in the cell, 0 to 1 along each axis. Returns the mixture of the 16 numbers:
// along each axis the upper corner has the weight s(t) = 6 t^5 - 15 t^4 + 10 t^3, with t the
// component of f, and the lower corner has 1 - s(t).
//
// The fourth axis is time. Keep the cell in integers: after a week at one cell per second it
// is 604,800, which an integer holds exactly, so that f is as fine as in the first second.
// [/noise_4d]
float noise_4d(ivec4 cell, vec4 f) {
    return lattice_4d(cell);
}
