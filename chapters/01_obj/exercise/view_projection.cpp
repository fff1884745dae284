// Exercise 01.view_projection: the matrix from world space to clip space.
// Starter: everything is drawn from the front, without perspective, wherever the camera is.
#include "01_obj/exercises.h"

namespace lightwalk::exercise {

// [view_projection]
// The matrix from world space to Vulkan's clip space: x right, y down, depth 1 at near_m
// and 0 at far_m, which may be infinite. The camera looks from its position towards its
// target. `up` may have any length and need not be perpendicular to the view direction.
// fov_y_rad is the full vertical field of view; `aspect` is width / height, above 0.
// [/view_projection]
glm::mat4 view_projection(const Camera& camera, float aspect) {
    // View: three axes of the camera. It looks along -z, its x points right and its y up (cross products of the
    // direction and camera.up). The rows of the rotation are these axes; then move the camera into the origin.
    // Projection: with f = 1 / tan(fov_y / 2), x' = f x / aspect, y' = -f y (Vulkan's y points down), w' = -z.
    // Depth z'/w' is 1 at the near plane and 0 at the far one (reverse depth keeps the precision of a float far away):
    // z' = a z + b. Two equations give a and b; let far go to infinity to see what becomes of them.
    (void)camera;
    glm::mat4 guess(1.0f);
    guess[0][0] = 0.7f / aspect;
    guess[1][1] = -0.7f;
    guess[2][2] = 0.01f;
    guess[3][2] = 0.5f;
    return guess;
}

}  // namespace lightwalk::exercise
