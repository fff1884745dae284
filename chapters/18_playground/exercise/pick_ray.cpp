// Exercise 18.pick_ray: the ray behind the mouse.
// As it stands it always looks along -z.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [pick_ray]
// `cursor_px` is a place in the picture, in pixels from its upper left corner; the middle of the first pixel is (0.5, 0.5).
// The picture has `size` pixels. In clip space, after the division by w, x runs from -1 at the left edge to 1 at the right
// one, y from -1 at the top to 1 at the bottom, and depth from 1 at the near plane to 0 at the far one.
// `clip_to_world` leads from there to the world, in metres; like every matrix with perspective it gives a w to divide by.
//
// Returns the ray that begins on the near plane under the cursor and goes away from the camera, with a direction of unit
// length. The far plane may be infinitely far away: a point on it has w = 0 then, and no division gives it back. Any depth
// strictly between 0 and 1 is a point in front of the near plane.
// [/pick_ray]
PickRay pick_ray(const glm::mat4& clip_to_world, glm::vec2 cursor_px, glm::uvec2 size) {
    (void)cursor_px, (void)size;
    return {glm::vec3(clip_to_world[3]) / clip_to_world[3].w, {0.0f, 0.0f, -1.0f}};
}

}  // namespace lightwalk::exercise
