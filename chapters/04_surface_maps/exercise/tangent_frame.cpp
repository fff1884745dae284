// Exercise 04.tangent_frame: the directions in which a texture's u and v grow on a triangle.
// Starter: the tangent is the world's x axis: right for a wall that faces +z, and wrong for all else.
#include "04_surface_maps/exercises.h"

namespace lightwalk::exercise {

// [tangent_frame]
// The frame at corner `a` of the triangle a, b, c. `tangent` is a unit vector,
// perpendicular to a.normal (a unit vector), that points where u grows. `handedness` is 1
// if v grows along cross(normal, tangent), and -1 if v grows against it, where the texture
// is mirrored. `metres_per_uv` holds the lengths of dP/du and dP/dv. If the texture
// coordinates, or the triangle, span no area, these derivatives do not exist: return any
// unit vector perpendicular to the normal as the tangent, handedness 1 and metres_per_uv 0.
// Leave cos_uv at 0: the caller fills it in when it joins the frames of all triangles at a
// vertex.
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
