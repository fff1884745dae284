// Exercise 14.sh_project: an environment as nine colours.
// Starter: the environment is black, and so is diffuse light by the method sh9.
#include "14_environment/exercises.h"

namespace lightwalk::exercise {

// [sh_project]
// Projects an equirectangular picture of radiance on the nine real spherical harmonics up
// to degree 2: coefficient i is the integral over the sphere of radiance times Y_i, as a
// sum over all texels, each weighted by its solid angle.
// The picture's middle looks along -z, its right quarter along +x, its upper edge is +y: a
// texel in column c and row r looks along (sin phi sin theta, cos theta, -cos phi sin
// theta) with theta = pi (r + 1/2) / height and
// phi = 2 pi (c + 1/2) / width - pi. The harmonics of a direction (x, y, z) of unit length
// are
//
//     Y0 = 0.282095      Y1 = 0.488603 y                 Y2 = 0.488603 z
//     Y3 = 0.488603 x    Y4 = 1.092548 xy                Y5 = 1.092548 yz
//     Y6 = 0.315392 (3 z² - 1)      Y7 = 1.092548 xz     Y8 = 0.546274 (x² - y²)
//
// The texels stand row by row from the upper edge: texels[r * width + c]. The result has
// nine colours. Rows near the poles cover less of the sphere than rows at the horizon: a
// texel of row r has the solid angle 2 pi / width * (cos(pi r / height) - cos(pi (r + 1) /
// height)), so that those of all texels add up to 4 pi. Tolerance: 1e-5 plus 1e-5 of the
// coefficient.
// [/sh_project]
Sh9 sh_project(int /*width*/, int /*height*/, const std::vector<glm::vec3>& /*texels*/) { return Sh9(9); }

}  // namespace lightwalk::exercise
