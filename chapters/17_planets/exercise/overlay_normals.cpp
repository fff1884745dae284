// Exercise 17.overlay_normals: slopes from the brightness of a planet's map.
// Starter: the planet is smooth.
#include "17_planets/exercises.h"

namespace lightwalk::exercise {

// [overlay_normals]
// Of most bodies we have no heights, only a colour map, whose brightness stands in for them:
// craters have bright rims and dark floors. One scale alone does not suffice: differences
// between neighbours show grain but no mountains, those of a blurred map mountains but no
// detail. So the map is separated into octaves, and each is made as steep as the others:
//   1. Octave 0 is the map minus the map blurred by a box of radius 1; octave i is the map
//      blurred by radius 2^(i-1) minus the map blurred by radius 2^i. The box of radius r is 2r
//      + 1 texels wide, along each row, then along each column.
//   2. Divide each octave by the standard deviation of all its texels (an octave with less than
//      1e-9 adds nothing), and multiply by the size of its features, 2^i texels, so that all
//      octaves have slopes of one size. Add them.
//   3. The slopes of the sum h are its central differences per texel: dx = (h(x + 1, y) - h(x -
//      1, y)) / 2 towards the east, and dy = (h(x, y - 1) - h(x, y + 1)) / 2 towards the north,
//      which is the row above. The normal is normalize(-f dx, -f dy, 1) with f = slope /
//      octaves; `slope` sets the height of the relief.
// The map is equirectangular, row 0 at the north pole: rows go around the planet, so that x
// wraps, and columns end at the poles, where y is clamped to the map. `brightness` has width
// times height numbers, row by row. `octaves` is 1 to 8. Returns as many normals: x east, y
// north, z up. Blurring by running sums takes the same time at any radius.
// [/overlay_normals]
std::vector<glm::vec3> overlay_normals(int width, int height, std::span<const float> brightness, int octaves,
                                       float slope) {
    (void)brightness, (void)octaves, (void)slope;
    return std::vector<glm::vec3>(static_cast<size_t>(width) * static_cast<size_t>(height), glm::vec3(0, 0, 1));
}

}  // namespace lightwalk::exercise
