// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/camera_relative.cpp.
EXERCISE("17.camera_relative", glm::mat4, camera_relative, const glm::dmat4& object_to_world,
         const glm::dvec3& camera_m);

/// Specification: exercise/overlay_normals.cpp.
EXERCISE("17.overlay_normals", std::vector<glm::vec3>, overlay_normals, int width, int height,
         std::span<const float> brightness, int octaves, float slope);

}  // namespace lightwalk
