// Exercise 07.level_sizes: how many levels there are, and how large each is.
// As it stands an image has one level: however far away it is, all of its texels are there, and it flickers.
#include "07_mipmaps/exercises.h"

namespace lightwalk::exercise {

// [level_sizes]
// The sizes of all levels of an image, in texels: `size` (each side 1 or more) first, then each half of the one before,
// rounded down, but no side below 1, until the last is 1×1 and nothing comes after it.
// [/level_sizes]
std::vector<glm::uvec2> level_sizes(glm::uvec2 size) { return {size}; }

}  // namespace lightwalk::exercise
