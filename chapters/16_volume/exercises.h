// The C++ exercise of this chapter. Its name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/preintegrate.cpp.
EXERCISE("16.preintegrate", glm::vec4, preintegrate, std::span<const glm::vec4> transfer, float front, float back,
         float ratio);

}  // namespace lightwalk
