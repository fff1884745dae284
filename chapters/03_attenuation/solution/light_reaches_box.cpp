#include <cmath>

#include "03_attenuation/exercises.h"

namespace lightwalk::solution {

bool light_reaches_box(const Light& light, float radius_m, const Bounds& box) {
    if (light.kind == Light::Kind::directional) return true;
    if (radius_m == 0.0f) return false;
    const float slack = 1e-3f * radius_m;  // more than any rounding error
    const glm::vec3 nearest = glm::clamp(light.position, box.lower, box.upper);
    if (glm::distance(light.position, nearest) > radius_m + slack) return false;
    if (light.kind == Light::Kind::point) return true;

    const glm::vec3 middle = box.center() - light.position;
    const float along = glm::dot(middle, light.direction), across = glm::length(glm::cross(middle, light.direction));
    const float away = glm::length(middle), cos_outer = std::cos(light.outer_rad);
    if (along >= away * cos_outer) return true;  // the centre is in the cone
    // Distance of the centre times sine and cosine of its angle to the cone's side. Beyond 90 degrees the apex is nearest.
    const float sin_outer = std::sqrt(std::max(1.0f - cos_outer * cos_outer, 0.0f));
    const float sine = across * cos_outer - along * sin_outer, cosine = along * cos_outer + across * sin_outer;
    return (cosine < 0.0f ? away : sine) <= 0.5f * glm::length(box.extent()) + slack;
}

}  // namespace lightwalk::solution
