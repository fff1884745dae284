// wrong: expected x =
#include <cmath>

#include "01_obj/exercises.h"

namespace lightwalk::exercise {

glm::mat4 view_projection(const Camera& camera, float aspect) {
    const glm::vec3 back = glm::normalize(camera.position - camera.target);
    const glm::vec3 right = glm::normalize(glm::cross(camera.up, back));
    const glm::vec3 up = glm::cross(back, right);
    // glm's matrices are columns: the transpose puts the axes into the rows.
    glm::mat4 view(glm::transpose(glm::mat3(right, up, back)));
    view[3] = glm::vec4(-glm::dot(right, camera.position), -glm::dot(up, camera.position),
                        -glm::dot(back, camera.position), 1.0f);

    // z' = a z + b with w' = -z: depth 1 at z = -near gives b - a n = n, depth 0 at z = -far gives b = a f, hence
    // a = n / (f - n). Divided through by f it also holds for an infinite far plane.
    const float near_over_far = camera.near_m / camera.far_m;
    const float f = 1.0f / std::tan(0.5f * camera.fov_y_rad);
    glm::mat4 projection(0.0f);
    projection[0][0] = f / aspect;
    projection[1][1] = f;
    projection[2][2] = near_over_far / (1.0f - near_over_far);
    projection[2][3] = -1.0f;
    projection[3][2] = camera.near_m / (1.0f - near_over_far);
    return projection * view;
}

}  // namespace lightwalk::exercise
