// Pinhole camera.
#pragma once
#include <glm/glm.hpp>

namespace lightwalk {

/// Right-handed world, +y up. `target` must differ from `position`; `up` must not be parallel to the view direction.
struct Camera {
    glm::vec3 position{0.0f, 0.0f, 3.0f};  ///< metres
    glm::vec3 target{0.0f};                ///< metres; at the centre of the picture
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float fov_y_rad = 0.8f;  ///< full vertical field of view, in (0, pi)
    float near_m = 0.05f;    ///< above 0; maps to depth 1
    float far_m = 1000.0f;   ///< above near_m, may be infinite; maps to depth 0

    /// Camera moved forwards along the ground; unchanged if it looks straight up or down.
    Camera walked(float metres) const {
        Camera there = *this;
        const glm::vec3 ahead = (target - position) * glm::vec3(1, 0, 1);
        const float length = glm::length(ahead);
        const glm::vec3 step = length > 0 ? metres / length * ahead : glm::vec3(0);
        there.position += step, there.target += step;
        return there;
    }
};

}  // namespace lightwalk
