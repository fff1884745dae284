// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// exercise/spectrum_bands.cpp says what it must do.
EXERCISE("14.spectrum_bands", glm::vec3, spectrum_bands, const std::vector<float>& samples, float rate_hz);

}  // namespace lightwalk
