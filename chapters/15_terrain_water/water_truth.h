// Double-precision references of the water's exercises.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace lightwalk::truth {

/// Displacement by one wave, metres, as 15_terrain_water/gerstner.glsl has it.
inline glm::dvec3 gerstner(glm::dvec2 at, glm::dvec2 k, double amplitude, double steepness, double phase) {
    const double t = glm::dot(k, at) - phase;
    const glm::dvec2 along = k / glm::length(k) * steepness * amplitude * std::cos(t);
    return {along.x, amplitude * std::sin(t), along.y};
}

/// Its derivatives by x, y (none) and z.
inline glm::dmat3 gerstner_slopes(glm::dvec2 at, glm::dvec2 k, double amplitude, double steepness, double phase) {
    const double t = glm::dot(k, at) - phase, k_length = glm::length(k);
    glm::dmat3 slopes(0.0);
    for (const int axis : {0, 1})
        slopes[axis == 0 ? 0 : 2] =
            k[axis] * glm::dvec3(-steepness * amplitude * std::sin(t) * k.x / k_length, amplitude * std::cos(t),
                                 -steepness * amplitude * std::sin(t) * k.y / k_length);
    return slopes;
}

inline glm::dvec3 normal_of(const glm::dmat3& slopes) {
    const glm::dvec3 normal = glm::cross(glm::dvec3(0, 0, 1) + slopes[2], glm::dvec3(1, 0, 0) + slopes[0]);
    return glm::length(normal) > 0 ? glm::normalize(normal) : glm::dvec3(0, 1, 0);
}

/// As exercise 15.fresnel_water says.
inline double fresnel_water(double cosine, double eye_index, double other_index) {
    double c = std::clamp(cosine, 0.0, 1.0);
    const double f0 = std::pow((eye_index - other_index) / (eye_index + other_index), 2);
    if (eye_index > other_index) {
        const double sine = eye_index / other_index * std::sqrt(1 - c * c);
        if (sine >= 1) return 1;
        c = std::sqrt(1 - sine * sine);
    }
    return f0 + (1 - f0) * std::pow(1 - c, 5);
}

/// Unpolarised light at a smooth surface, exactly: A.-J. Fresnel, 1823.
inline double fresnel_exact(double cosine, double eye_index, double other_index) {
    const double sine = eye_index / other_index * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double t = std::sqrt(1 - sine * sine);
    const double across = (eye_index * cosine - other_index * t) / (eye_index * cosine + other_index * t);
    const double along = (other_index * cosine - eye_index * t) / (other_index * cosine + eye_index * t);
    return 0.5 * (across * across + along * along);
}

}  // namespace lightwalk::truth
