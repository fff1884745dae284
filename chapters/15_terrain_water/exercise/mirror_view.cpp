// Exercise 15.mirror_view: what a level water surface reflects, drawn by the camera's own matrix.
// As it stands the water shows the picture itself, not upside down.
#include "15_terrain_water/exercises.h"

namespace lightwalk::exercise {

// [mirror_view]
// `view_projection` takes a place in the world (metres, +y up) to clip space: y down, depth z/w = 1 at the near plane and 0
// at the far plane or at infinity. The water lies at y = water_m; the eye is above it. The result takes a place of the world
// to where the camera sees its mirror image in the water, with two properties:
//
// 1. Where view_projection puts (x, 2 water_m - y, z) at (a, b, ., w), the result puts (x, y, z) at (-a, b, ., w). A mirror
//    turns counter-clockwise triangles into clockwise ones, which would be culled; turning left and right around turns
//    them back. So water that looks up its reflection at its own pixel, counted from the other edge, finds it.
// 2. What lies below the water must not show, or the ground of the lake stands before what is reflected. The near plane is
//    therefore the water: with (x, y, z, w) the result for a place, w - z is 0 where the place lies in the water's plane,
//    above 0 for places above the water, and below 0 for those below it, which the device then clips.
//
// For every place above the water that the camera sees mirrored, z must be at least 0, or the device clips it at the far
// plane; and z/w must fall as places on one ray of the mirrored eye go away from it. E. Lengyel's way ("Oblique View
// Frustum Depth Projection and Clipping", Journal of Game Development 1(2), 2005) is to replace the third row of the
// mirrored matrix by the fourth row minus s times the plane (0, 1, 0, -water_m), with the largest s > 0 that keeps all
// corners of the far plane in front of it: z >= 0 there. Corners at infinity are directions. Any s up to that is accepted
// as long as it is at least half as large.
// [/mirror_view]
glm::mat4 mirror_view(const glm::mat4& view_projection, float water_m) {
    (void)water_m;
    return view_projection;
}

}  // namespace lightwalk::exercise
