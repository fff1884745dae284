#include <cmath>

#include "03_attenuation/exercises.h"

namespace lightwalk::solution {

bool light_reaches_box(const Light& light, float radius_m, const Bounds& box) {
    if (light.kind == Light::Kind::directional) return true;
    if (radius_m == 0.0f) return false;
    const float slack = 1e-3f * radius_m;  // more than what rounding can do
    const glm::vec3 nearest = glm::clamp(light.position, box.lower, box.upper);
    if (glm::distance(light.position, nearest) > radius_m + slack) return false;
    if (light.kind == Light::Kind::point) return true;

    // With the angle a between the way to the ball's middle and the cone's side, the distance to the side is that way's
    // length times sin a. Beyond 90 degrees the apex is what is nearest.
    const glm::vec3 middle = box.center() - light.position;
    const float along = glm::dot(middle, light.direction), across = glm::length(glm::cross(middle, light.direction));
    const float cosine = std::cos(light.outer_rad), sine = std::sin(light.outer_rad);
    const bool beside = along * cosine + across * sine > 0.0f;
    const float distance = beside ? across * cosine - along * sine : glm::length(middle);
    return distance <= 0.5f * glm::length(box.extent()) + slack;
}

}  // namespace lightwalk::solution
