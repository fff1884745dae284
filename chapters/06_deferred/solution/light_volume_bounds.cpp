// Solution of 06.light_volume_bounds.
#include <cmath>

#include "06_deferred/exercises.h"

namespace lightwalk::solution {

LightVolume light_volume_bounds(const Light& light, float radius_m) {
    const glm::vec4 position(light.position, 1.0f);
    const float base = std::tan(light.outer_rad);  // for a height of 1
    // base^2 / 3 against 4 / 3: beyond 63 degrees the sphere is smaller. From 90 degrees on there is no cone.
    if (light.kind == Light::Kind::spot && light.outer_rad < 1.5f && base * base < 4.0f) {
        const glm::vec3 z = light.direction;
        const glm::vec3 x =
            glm::normalize(glm::cross(std::abs(z.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), z));
        const glm::vec3 y = glm::cross(z, x);
        const float across_m = radius_m * base;
        return {LightVolume::Shape::cone, glm::mat4(glm::vec4(across_m * x, 0.0f), glm::vec4(across_m * y, 0.0f),
                                                    glm::vec4(radius_m * z, 0.0f), position)};
    }
    glm::mat4 ball(radius_m);
    ball[3] = position;
    return {LightVolume::Shape::sphere, ball};
}

}  // namespace lightwalk::solution
