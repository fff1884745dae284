// Exercise 05.fit_cascade: the part of the world that a cascade covers.
// Starter: a ball around the camera, half of which lies behind it, and a map that moves with every step.
#include <cmath>

#include "05_shadow_maps/exercises.h"

namespace lightwalk::exercise {

// [fit_cascade]
// fit_slice(): the smallest ball around a slice of the camera's view, the part between the planes
// at near_m and at far_m in front of the camera (metres, 0 < near_m < far_m). Returns the distance
// from the camera to the ball's centre, which lies on the axis of the view, and the radius, both in
// metres. `tan_half` is the tangent of half the vertical field of view, above 0; `aspect`, above 0,
// is the width of the picture over its height. Tolerance: 1e-4 of the radius.
glm::vec2 fit_slice(float tan_half, float aspect, float near_m, float far_m) {
    (void)near_m;
    return {0.0f, far_m * std::sqrt(1.0f + (1.0f + aspect * aspect) * tan_half * tan_half)};
}

// snap_middle(): the centre that a map gets instead of `middle`, the centre of the ball. Both are
// positions along the map's two axes, in metres. The result is less than a texel from `middle` along
// each axis; a texel is `texel` metres wide, above 0. Shadows must stay as they are while the camera
// moves: for a given `texel`, the borders of texels always lie at the same positions in the world.
glm::vec2 snap_middle(glm::vec2 middle, float texel) {
    (void)texel;
    return middle;
}
// [/fit_cascade]

}  // namespace lightwalk::exercise
