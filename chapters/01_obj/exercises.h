// C++ exercises of this chapter. Each name calls the student's version or the reference, as the switch says.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "01_obj/obj.h"
#include "common/base/exercise.h"
#include "common/scene/camera.h"

namespace lightwalk {

/// Specification: exercise/parse_vertex_line.cpp.
EXERCISE("01.parse_vertex_line", glm::vec3, parse_vertex_line, std::string_view line);

/// Specification: exercise/parse_face.cpp.
EXERCISE("01.parse_face", std::vector<Corner>, parse_face, std::string_view line, const Counts& so_far,
         const Counts& total);

/// Specification: exercise/triangulate.cpp.
EXERCISE("01.triangulate", std::vector<glm::uvec3>, triangulate, std::span<const glm::vec3> polygon);

/// Specification: exercise/view_projection.cpp.
EXERCISE("01.view_projection", glm::mat4, view_projection, const Camera& camera, float aspect);

}  // namespace lightwalk
