// Exercise 18.pick_ray: the ray behind the mouse.
// Starter: it always looks along -z.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [pick_ray]
// `cursor_px` is a point in the picture, in pixels from its upper left corner; the middle of
// the first pixel is (0.5, 0.5). The picture has `size` pixels. In clip space, after the
// division by w, x runs from -1 at the left edge to 1 at the right edge, y from -1 at the top
// to 1 at the bottom, and depth from 1 at the near plane to 0 at the far plane. `clip_to_world`
// takes a point (x, y, depth, 1) from there to the world, in metres; the result has a w, by
// which it is to be divided.
//
// Returns the ray that begins on the near plane under the cursor and goes away from the camera,
// with a direction of unit length. The direction needs a second point on the ray. Any depth
// strictly between 0 and 1 gives one beyond the near plane. Depth 0 may not: if the far plane
// is infinitely far away, its points have w = 0.
//
// Tolerance: 2e-5 for the direction. At depth 0.5 and a near plane at 0.05 m the two points are
// only 0.05 m apart, and 20 m from the origin floats are too coarse for their difference.
// Compute in double precision, or take a point farther away.
// [/pick_ray]
PickRay pick_ray(const glm::mat4& clip_to_world, glm::vec2 cursor_px, glm::uvec2 size) {
    (void)cursor_px, (void)size;
    return {glm::vec3(clip_to_world[3]) / clip_to_world[3].w, {0.0f, 0.0f, -1.0f}};
}

}  // namespace lightwalk::exercise
