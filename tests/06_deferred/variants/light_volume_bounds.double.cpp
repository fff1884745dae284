// right
#include <cmath>

#include "06_deferred/exercises.h"

namespace lightwalk::exercise {

LightVolume light_volume_bounds(const Light& light, float radius_m) {
    LightVolume volume;
    const double half = double(light.outer_rad);
    if (light.kind == Light::Kind::spot && half < std::atan(2.0)) {
        volume.shape = LightVolume::Shape::cone;
        const glm::dvec3 z(light.direction);
        glm::dvec3 x = std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
        x = glm::normalize(x - z * glm::dot(x, z));
        const double wide = double(radius_m) * std::tan(half);
        volume.to_world[0] = glm::vec4(glm::vec3(wide * x), 0.0f);
        volume.to_world[1] = glm::vec4(glm::vec3(wide * glm::cross(z, x)), 0.0f);
        volume.to_world[2] = glm::vec4(radius_m * light.direction, 0.0f);
    } else {
        for (int i = 0; i < 3; ++i) volume.to_world[i][i] = 1.0005f * radius_m;
    }
    volume.to_world[3] = glm::vec4(light.position, 1.0f);
    return volume;
}

}  // namespace lightwalk::exercise
