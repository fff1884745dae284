// Exercise 07.level_sizes: number and sizes of the levels of an image.
// Starter: an image has one level: all of its texels are read at any distance, and it flickers.
#include "07_mipmaps/exercises.h"

namespace lightwalk::exercise {

// [level_sizes]
// Returns the sizes of all levels of an image, in texels, largest first. The first is
// `size` itself, each side of which is 1 or more. Each further level has half the width
// and half the height of the one before, rounded down, but no side below 1. The list
// ends with the first level of 1×1 texels.
// [/level_sizes]
std::vector<glm::uvec2> level_sizes(glm::uvec2 size) { return {size}; }

}  // namespace lightwalk::exercise
