// Exercise 15.mirror_view: what a level water surface reflects, drawn by the camera's own matrix.
// Starter: the water shows the picture itself, not upside down.
#include "15_terrain_water/exercises.h"

namespace lightwalk::exercise {

// [mirror_view]
// `view_projection` takes a point in the world (metres, +y up) to clip space: y down, depth z/w
// = 1 at the near plane and 0 at the far plane or at infinity. The water lies at y = water_m,
// and the eye is above it. Returns a matrix that takes a point in the world to where the camera
// sees its mirror image in the water. The matrix has three properties:
//
// 1. Left and right are swapped. Where view_projection puts (x, 2 water_m - y, z) at (a, b, .,
//    w), the result puts (x, y, z) at (-a, b, ., w). The reason: a mirror turns
//    counter-clockwise triangles into clockwise ones, which would be culled, and the swap turns
//    them back. The water finds its reflection at its own pixel, counted from the other edge.
// 2. The near plane is the water, because the ground of the lake would otherwise hide the
//    reflected scene. Let the result take a point to (x, y, z, w). Then w - z is 0 for points
//    in the water's plane, above 0 for points above the water, and below 0 for points below it,
//    which the device clips.
// 3. The far plane clips nothing that shows. For every point above the water that the camera
//    sees mirrored, z is at least 0. Along each ray of the mirrored eye z/w falls with the
//    distance.
//
// E. Lengyel ("Oblique View Frustum Depth Projection and Clipping", Journal of Game Development
// 1(2), 2005) replaces the third row of the mirrored matrix by its fourth row minus s times the
// plane (0, 1, 0, -water_m). His s is the largest one above 0 for which z >= 0 at the four
// corners of the far plane. In homogeneous coordinates these corners are the inverse of the
// mirrored matrix times (+-1, +-1, 0, 1); their fourth component is 0 if they are at infinity.
// A smaller s is accepted, too, down to half of the largest. Where no corner lies above the
// water, any s above 0 will do.
// [/mirror_view]
glm::mat4 mirror_view(const glm::mat4& view_projection, float water_m) {
    (void)water_m;
    return view_projection;
}

}  // namespace lightwalk::exercise
