// References of this chapter, in double precision. Directions have unit length.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace lightwalk::truth {

inline double lambert(glm::dvec3 normal, glm::dvec3 to_light) { return std::max(glm::dot(normal, to_light), 0.0); }

/// 0 where the light is behind the surface or the cosine is not above 0.
inline double phong(glm::dvec3 normal, glm::dvec3 to_light, glm::dvec3 to_eye, double shininess) {
    const double received = glm::dot(normal, to_light);
    const double cosine = glm::dot(2.0 * received * normal - to_light, to_eye);
    return received > 0.0 && cosine > 0.0 ? std::pow(std::min(cosine, 1.0), shininess) : 0.0;
}

/// As phong(), with the half vector; 0 where there is none (to_light = -to_eye).
inline double blinn_phong(glm::dvec3 normal, glm::dvec3 to_light, glm::dvec3 to_eye, double shininess) {
    const glm::dvec3 between = to_light + to_eye;
    const double length = glm::length(between);
    const double cosine = length > 1e-9 ? glm::dot(normal, between) / length : 0.0;
    return glm::dot(normal, to_light) > 0.0 && cosine > 0.0 ? std::pow(std::min(cosine, 1.0), shininess) : 0.0;
}

/// pi divided by the integral of the lobe times the cosine over the hemisphere, eye at the zenith: exact.
inline double blinn_phong_normalisation(double n) { return (n + 2.0) * (n + 4.0) / (8.0 * (std::exp2(-0.5 * n) + n)); }

/// The same by quadrature: `steps` midpoints in the angle of the light, which is all the integrand depends on.
inline double blinn_phong_normalisation_by_quadrature(double n, int steps = 20000) {
    const double step = 0.5 * std::numbers::pi / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double theta = (i + 0.5) * step;
        sum += std::pow(std::cos(0.5 * theta), n) * std::cos(theta) * std::sin(theta) * step;
    }
    return 1.0 / (2.0 * sum);
}

inline double wrapped_diffuse(double cosine, double wrap, double power) {
    const double wrapped = (cosine + wrap) / (1.0 + wrap);
    return wrapped > 0.0 ? std::pow(wrapped, power) : 0.0;
}

inline glm::dvec3 wrapped_tint(double cosine, glm::dvec3 tint) {
    return glm::mix(tint, glm::dvec3(1.0), std::min(std::max(cosine, 0.0), 1.0));
}

}  // namespace lightwalk::truth
