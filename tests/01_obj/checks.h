// What an exercise of chapter 01 must do, as checks of any version of it. Each returns what is wrong, in a student's
// words, and nothing where all is right. They run fixed inputs, in well under a second.
#pragma once
#include <string>
#include <vector>

#include "01_obj/exercises.h"

namespace lightwalk {

using Failures = std::vector<std::string>;

Failures check_parse_vertex_line(glm::vec3 (*attempt)(std::string_view));
Failures check_parse_face(std::vector<Corner> (*attempt)(std::string_view, const Counts&, const Counts&));
Failures check_triangulate(std::vector<glm::uvec3> (*attempt)(std::span<const glm::vec3>));
Failures check_view_projection(glm::mat4 (*attempt)(const Camera&, float));

}  // namespace lightwalk
