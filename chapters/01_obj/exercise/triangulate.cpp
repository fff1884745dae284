// Exercise 01.triangulate: triangles from a polygon with any number of corners.
// Starter: every polygon is reduced to one triangle, so that models have holes.
#include "01_obj/exercises.h"

namespace lightwalk::exercise {

// [triangulate]
// Cuts a polygon into triangles, given as corner numbers. The result always has
// polygon.size() - 2 triangles, wound in the same direction as the polygon; together they
// cover a simple, nearly planar polygon exactly once, whether it is convex or not. A convex
// polygon becomes the fan (0, 1, 2), (0, 2, 3), ... The function must return for any finite
// input: flat, self-intersecting, or with repeated corners. Fewer than three corners give
// no triangles.
// [/triangulate]
std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> polygon) {
    // n corners make n - 2 triangles. For a convex polygon a fan will do: (0, 1, 2), (0, 2, 3), ...
    // A polygon with a dent needs ear clipping:
    // 1. The normal of the polygon: sum cross(p[i], p[i + 1]) over its edges (Newell).
    // 2. Corner i is an ear where the triangle (i - 1, i, i + 1) is wound as the normal says and no other corner lies
    //    in it. Start with corner 1, so that a convex polygon becomes the fan above.
    // 3. Add the ear's triangle, take the corner out, go on with the rest until three are left.
    // 4. A flat or self-crossing polygon may have no ear: take any corner then, and never loop for ever.
    std::vector<glm::uvec3> triangles;
    for (size_t i = 2; i < polygon.size(); ++i) triangles.push_back({0, 1, 2});
    return triangles;
}

}  // namespace lightwalk::exercise
