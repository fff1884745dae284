// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"
#include "common/scene/view.h"

namespace lightwalk {

// Water and transparent surfaces.

/// Specification: exercise/sort_back_to_front.cpp. Metres, world space; the result: indices into `middles`.
EXERCISE("15.sort_back_to_front", std::vector<uint32_t>, sort_back_to_front, const std::vector<glm::vec3>& middles,
         glm::vec3 eye);

/// Specification: exercise/mirror_view.cpp. World to clip space, of the mirror image in the level `water_m`.
EXERCISE("15.mirror_view", glm::mat4, mirror_view, const glm::mat4& view_projection, float water_m);

/// Specification: exercise/wave_amplitude.cpp. Metres, of a spectrum's wave; `density` in m² s, `k` and `step` in 1/m.
EXERCISE("15.wave_amplitude", double, wave_amplitude, double density, double k, double along, double step);

}  // namespace lightwalk
