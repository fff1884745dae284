// right
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "01_obj/exercises.h"

namespace lightwalk::exercise {

glm::mat4 view_projection(const Camera& camera, float aspect) {
    const float n = camera.near_m, f = 1.0f / std::tan(camera.fov_y_rad / 2.0f);
    const float a = std::isinf(camera.far_m) ? 0.0f : n / (camera.far_m - n), b = n + n * a;
    glm::mat4 projection(0.0f);
    projection[0] = {f / aspect, 0, 0, 0};
    projection[1] = {0, -f, 0, 0};
    projection[2] = {0, 0, a, -1};
    projection[3] = {0, 0, b, 0};
    return projection * glm::lookAt(camera.position, camera.target, camera.up);
}

}  // namespace lightwalk::exercise
