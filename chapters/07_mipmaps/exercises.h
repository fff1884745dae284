// The C++ exercise of this chapter. The name calls the exercise or the solution, according to the toggle.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/level_sizes.cpp.
EXERCISE("07.level_sizes", std::vector<glm::uvec2>, level_sizes, glm::uvec2 size);

}  // namespace lightwalk
