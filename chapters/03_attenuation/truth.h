// References of this chapter, in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "common/scene/light.h"
#include "common/scene/mesh.h"

namespace lightwalk::truth {

inline double range_fade(double distance, double range, double k) {
    if (!(distance < range)) return 0.0;
    return std::pow(1.0 - distance / range, 2.0) / (1.0 + k * distance * distance);
}

inline double inverse_square_window(double distance, double range) {
    if (!(distance < range)) return 0.0;
    return std::pow(1.0 - std::pow(distance / range, 4.0), 2.0) / (distance * distance + 1.0);
}

/// Cosines in [-1, 1], cos_inner >= cos_outer. A cosine that equals both is outside.
inline double spot_cone(double cosine, double cos_inner, double cos_outer, double softness) {
    if (cosine <= cos_outer) return 0.0;
    if (cosine >= cos_inner) return 1.0;
    return std::pow((cosine - cos_outer) / (cos_inner - cos_outer), 1.0 + (0.35 - 1.0) * softness);
}

/// The distance in metres from a point to a cone that goes on for ever: 0 inside. `axis` has unit length.
inline double distance_to_cone(glm::dvec3 point, glm::dvec3 apex, glm::dvec3 axis, double half_angle_rad) {
    const double length = glm::length(point - apex);
    if (length == 0.0) return 0.0;
    const double angle = std::acos(std::clamp(glm::dot(point - apex, axis) / length, -1.0, 1.0)) - half_angle_rad;
    return angle <= 0.0 ? 0.0 : angle < 0.5 * std::numbers::pi ? length * std::sin(angle) : length;
}

/// By how many metres a point or spot light of that radius misses the box: its sphere, or its cone the ball around the
/// box, whichever is more. Below 0: it reaches it.
inline double misses_box_by(const Light& light, double radius_m, const Bounds& box) {
    const glm::dvec3 position(light.position), lower(box.lower), upper(box.upper);
    const double miss = glm::distance(position, glm::clamp(position, lower, upper)) - radius_m;
    if (light.kind != Light::Kind::spot) return miss;
    const double cone = distance_to_cone(0.5 * (lower + upper), position, glm::normalize(glm::dvec3(light.direction)),
                                         static_cast<double>(light.outer_rad));
    return std::max(miss, cone - 0.5 * glm::length(upper - lower));
}

}  // namespace lightwalk::truth
