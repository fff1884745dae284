// Exercise 17.camera_relative: from the solar system's metres to those before the camera.
// Starter: everything is rounded to floats first: at 30 AU they are 524 km apart.
#include "17_planets/exercises.h"

namespace lightwalk::exercise {

// [camera_relative]
// `object_to_world` turns a body's axes (columns 0 to 2, which may scale too) and moves it to
// its position in the world (column 3, metres from the Sun, up to 1e13). `camera_m` is the
// camera's position there. Returns the matrix from the body to the world as seen from the camera:
// the same axes, the camera at the origin. Its numbers are floats, each the one nearest to the
// true value. A body 1 m before a camera at Neptune must be within 1 mm of its position, and a
// body that is far away within a part in 10,000,000 of its distance. Row 3 stays (0, 0, 0, 1).
// [/camera_relative]
glm::mat4 camera_relative(const glm::dmat4& object_to_world, const glm::dvec3& camera_m) {
    glm::mat4 relative(object_to_world);
    relative[3] -= glm::vec4(glm::vec3(camera_m), 0.0f);
    return relative;
}

}  // namespace lightwalk::exercise
