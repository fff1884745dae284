// Exercise 11.quintic_noise: a smooth height between the numbers at a grid's corners.
// Until you fill it in, each cell is flat.
#include "11_fractals/lattice.glsl"

// [quintic_noise]
// The height at a place of a cell: `f`, 0 to 1 in x and y, is how far from the cell's first corner. At the corners it is
// lattice(cell), lattice(cell + ivec2(1, 0)), lattice(cell + ivec2(0, 1)) and lattice(cell + ivec2(1, 1)); in between it
// is mixed along x by s(f.x) and along y by s(f.y). s rises from 0 to 1, and where two cells meet neither the slope nor the
// curvature of the ground may have a step: s' and s'' are 0 at 0 and at 1. smoothstep, 3 t² - 2 t³, has a step in s'', which
// light shows as a line. Which polynomial of the fifth degree has none?
// [/quintic_noise]
float quintic_noise(ivec2 cell, vec2 f) {
    return lattice(cell);
}
