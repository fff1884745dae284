// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "01_obj/obj.h"
#include "common/base/exercise.h"
#include "common/scene/camera.h"

namespace lightwalk {

// [parse_vertex_line]
/// The position on a line `v x y z`, `v x y z w`, `v x y z r g b` or `v x y z w r g b`; w and the colour are dropped.
/// Every number is rounded correctly, in any locale. Throws InputError with the reason alone (the caller knows the
/// line's number) where a number is missing, one too many, not a number or too large for a float.
EXERCISE("01.parse_vertex_line", glm::vec3, parse_vertex_line, std::string_view line);
// [/parse_vertex_line]

// [parse_face]
/// The corners on a line `f c c c ...`, each `v`, `v/vt`, `v//vn` or `v/vt/vn`, as indices from 0. In the file 1 is the
/// first one and -1 the last one read so far, which `so_far` counts. `total` counts the whole file's. Throws InputError
/// with the reason alone where there are fewer than three corners, an index is 0, not a whole number or out of range.
EXERCISE("01.parse_face", std::vector<Corner>, parse_face, std::string_view line, const Counts& so_far,
         const Counts& total);
// [/parse_face]

// [triangulate]
/// A polygon cut into triangles, given as corner numbers: always polygon.size() - 2 of them, wound as the polygon is,
/// covering a simple, nearly planar polygon once, be it convex or not. A fan from corner 0 where it is convex. Must
/// return for any finite input, flat, crossing itself or with repeated corners. Fewer than three corners: none.
EXERCISE("01.triangulate", std::vector<glm::uvec3>, triangulate, std::span<const glm::vec3> polygon);
// [/triangulate]

// [view_projection]
/// World space to Vulkan's clip space: x right, y down, depth 1 at near_m and 0 at far_m (which may be infinity).
/// `aspect` is width / height, above 0.
EXERCISE("01.view_projection", glm::mat4, view_projection, const Camera& camera, float aspect);
// [/view_projection]

}  // namespace lightwalk
