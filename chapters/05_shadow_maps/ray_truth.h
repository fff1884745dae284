// References for rays and for shadows without maps, in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace lightwalk::truth {

constexpr double pi = 3.14159265358979323846;

/// The share of a disc of radius 1 that lies beyond a line `at` from its middle: 1 for -1, 0 for 1.
inline double disc_beyond(double at) {
    const double x = std::clamp(at, -1.0, 1.0);
    return (std::acos(x) - x * std::sqrt(1 - x * x)) / pi;
}

/// How far the line towards the light passes from the sphere's middle; a negative number where the sphere is behind.
inline double line_distance(glm::dvec3 to_center, glm::dvec3 to_light) {
    const glm::dvec3 l = glm::normalize(to_light);
    return glm::dot(to_center, l) > 0 ? glm::length(glm::cross(to_center, l)) : -1;
}

/// The share of a disc of radius 1 hidden by another, with its edge at distance `gap` from the first one's centre.
inline double hidden_share(double radius, double gap) {
    const double apart = radius + gap;
    if (gap >= 1) return 0;
    if (apart <= std::fabs(1 - radius)) return std::min(radius * radius, 1.0);
    const double chord = (gap * (2 * radius + gap) + 1) / (2 * apart);
    const double beyond = (apart - chord) / radius;  // 1 - beyond is the segment's height, tiny for a large disc
    const double half = std::sqrt(std::max(0.0, 1 - chord * chord)) / radius;
    const double angle = std::atan2(half, beyond);
    const double segment = angle < 1e-3 ? 2.0 / 3.0 * angle * angle * angle : angle - half * beyond;
    return disc_beyond(chord) + radius * radius * segment / pi;
}

/// The share of a cap of the sky of angular radius `sun` that one of radius `planet` hides, `apart` from middle to
/// middle, in radians: of solid angles, without taking either for flat (A. Tovchigrechko and I. A. Vakser, "How common
/// is the funnel-like energy landscape in protein-protein interactions?", Protein Science 10(8), 2001, appendix).
inline double hidden_solid_angle(double sun, double planet, double apart) {
    const double whole = 2 * pi * (1 - std::cos(sun));
    if (apart >= sun + planet) return 0;
    if (apart <= std::fabs(sun - planet)) return std::min(1.0, 2 * pi * (1 - std::cos(planet)) / whole);
    const auto arc = [](double c) { return std::acos(std::clamp(c, -1.0, 1.0)); };
    const double cs = std::cos(sun), cp = std::cos(planet), ca = std::cos(apart);
    const double ss = std::sin(sun), sp = std::sin(planet), sa = std::sin(apart);
    const double both = 2 * (pi - arc((ca - cs * cp) / (ss * sp)) - cs * arc((cp - ca * cs) / (sa * ss)) -
                             cp * arc((cs - ca * cp) / (sa * sp)));
    return both / whole;
}

/// Transmittance of a flat ring towards the light, from a point relative to its centre: tau is its optical depth
/// along its normal between the radii. 1 if the light's direction lies in the ring's plane.
inline double ring_transmittance(glm::dvec3 point, glm::dvec3 normal, glm::dvec3 to_light, double inner, double outer,
                                 double tau) {
    const double slope = glm::dot(to_light, normal);
    if (slope == 0) return 1;
    const double t = -glm::dot(point, normal) / slope, r = glm::length(point + t * to_light);
    return t > 0 && r >= inner && r <= outer ? std::exp(-tau / std::fabs(slope)) : 1;
}

}  // namespace lightwalk::truth
