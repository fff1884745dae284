// Exercise 04.tangent_frame: in which direction of space does a texture's u grow?
// As it stands the tangent is the world's x axis: right for a wall that faces +z, and wrong for all else.
#include "04_surface_maps/exercises.h"

namespace lightwalk::exercise {

// [tangent_frame]
// The frame at corner `a` of the triangle a, b, c. `tangent` has unit length, is perpendicular to a.normal (of unit
// length) and points where u grows; `handedness` is 1, or -1 where the texture is mirrored; `metres_per_uv` are the
// lengths of dP/du and dP/dv. Where the texture coordinates span no area, or the triangle none, there are no such
// directions: then the tangent is any unit vector perpendicular to the normal, the handedness 1 and metres_per_uv 0.
// cos_uv is left at 0: who joins the frames of all triangles at a vertex fills it in.
// [/tangent_frame]
TangentFrame tangent_frame(const Vertex& a, const Vertex& b, const Vertex& c) {
    // Two edges of the triangle, e1 = b - a and e2 = c - a, and how u and v change along them:
    //     e1 = du1 * T + dv1 * B        e2 = du2 * T + dv2 * B
    // Two equations; solve them for T = dP/du and B = dP/dv. The determinant is du1 * dv2 - du2 * dv1. When is it 0?
    // Then take from T what points along the normal, and make the rest unit length (Gram and Schmidt).
    // The handedness is the sign of dot(cross(normal, tangent), B).
    (void)b, (void)c;
    (void)a;
    return {.tangent = {1.0f, 0.0f, 0.0f}, .handedness = 1.0f, .metres_per_uv = {1.0f, 1.0f}};
}

}  // namespace lightwalk::exercise
