// Requirements of chapter 01's exercises, as checks of any version. They run fixed inputs, in well under a second.
#pragma once
#include "01_obj/exercises.h"
#include "common/check/check.h"

namespace lightwalk {

void check_parse_vertex_line(Check& check, glm::vec3 (*attempt)(std::string_view));
void check_parse_face(Check& check, std::vector<Corner> (*attempt)(std::string_view, const Counts&, const Counts&));
void check_triangulate(Check& check, std::vector<glm::uvec3> (*attempt)(std::span<const glm::vec3>));
void check_view_projection(Check& check, glm::mat4 (*attempt)(const Camera&, float));

}  // namespace lightwalk
