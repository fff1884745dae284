// The C++ exercises of this chapter. Each name calls the exercise or the solution, according to the toggle.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/gaussian_weights.cpp.
EXERCISE("08.gaussian_weights", std::vector<float>, gaussian_weights, float sigma_px, float truncation);

/// Specification: exercise/pair_taps.cpp.
EXERCISE("08.pair_taps", std::vector<glm::vec2>, pair_taps, const std::vector<float>& weights);

}  // namespace lightwalk
