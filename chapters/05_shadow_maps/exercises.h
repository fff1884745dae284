// C++ exercise of this chapter. The names call the student's version or the reference, as the switch says.
#pragma once
#include <glm/glm.hpp>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/fit_cascade.cpp.
EXERCISE("05.fit_cascade", glm::vec2, fit_slice, float tan_half, float aspect, float near_m, float far_m);
EXERCISE("05.fit_cascade", glm::vec2, snap_middle, glm::vec2 middle, float texel);

}  // namespace lightwalk
