// Double-precision references of this chapter.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace lightwalk::truth {

inline double smooth(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

inline double wrapped_terminator(double cosine, double w, double k) {
    const double lit = (cosine + w) / (1 + w);
    return lit > 0 ? std::pow(lit, k) : 0;
}

/// The share of a city's lamps that is seen.
inline double night_lights(double cosine, double cloud) { return smooth(-cosine / 0.12) * (1 - cloud); }

inline double limb_fade(double opacity, double mu, double width) {
    return mu <= 0 ? 0 : (1 - std::pow(1 - opacity, 1 / mu)) * smooth(mu / width);
}

// Radiance over that of a white Lambertian surface that faces the sun; the shaders divide by the value where both are overhead.
inline double lommel_seeliger(double mu0, double mu) { return mu0 > 0 ? 2 * mu0 / (mu0 + mu) : 0; }
inline double minnaert(double mu0, double mu, double k) {
    return mu0 > 0 ? std::pow(mu0, k) * std::pow(std::clamp(mu, 0.04, 1.0), k - 1) : 0;
}
inline double hapke(double mu0, double mu, double cos_phase) {
    if (mu0 <= 0 || mu <= 0) return 0;
    const double w = 0.28, g = 0.24, h = 0.06, surge0 = 1.0;
    const double phase = std::acos(std::clamp(cos_phase, -1.0, 1.0)), surge = surge0 / (1 + std::tan(phase / 2) / h);
    const double once = (1 - g * g) / std::pow(1 + g * g - 2 * g * cos_phase, 1.5);
    const auto H = [&](double x) { return (1 + 2 * x) / (1 + 2 * x * std::sqrt(1 - w)); };
    return 0.25 * w * mu0 / (mu0 + mu) * ((1 + surge) * once + H(mu0) * H(mu) - 1);
}

/// Light of a ball at a phase angle, over that at phase 0: `law(cosine, mu, cos_phase)` over its visible half.
template <class Law>
double phase_curve(const Law& law, double phase_rad, int steps = 400) {
    const auto light = [&](double phase) {
        // Latitude from the plane of sun and camera, longitude from the camera in it.
        double sum = 0;
        for (int j = 0; j < steps; ++j) {
            const double b = (-0.5 + (j + 0.5) / steps) * glm::pi<double>();
            for (int i = 0; i < steps; ++i) {
                const double l = (-0.5 + (i + 0.5) / steps) * glm::pi<double>();
                const double mu = std::cos(b) * std::cos(l), cosine = std::cos(b) * std::cos(l - phase);
                sum += law(cosine, mu, std::cos(phase)) * mu * std::cos(b);
            }
        }
        return sum;
    };
    return light(phase_rad) / light(0);
}

/// Visible share of the sun's disc past an ellipsoid, by `n` x `n` rays: 17.ellipsoid_shadow's reference.
inline double ellipsoid_shadow(glm::dvec3 point, glm::dvec3 pole, double radius, double flattening, glm::dvec3 to_sun,
                               double sun_rad, int n = 64) {
    const double stretch = 1 / (1 - flattening);
    const auto round = [&](glm::dvec3 v) { return v + (stretch - 1) * glm::dot(v, pole) * pole; };
    const glm::dvec3 side =
        glm::normalize(glm::cross(std::fabs(to_sun.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), to_sun));
    const glm::dvec3 up = glm::cross(to_sun, side);
    int seen = 0, all = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const glm::dvec2 at = 2.0 * glm::dvec2(i + 0.5, j + 0.5) / double(n) - 1.0;
            if (glm::dot(at, at) > 1) continue;
            const glm::dvec3 ray = round(to_sun + std::tan(sun_rad) * (at.x * side + at.y * up)), from = round(point);
            const double t = -glm::dot(from, ray) / glm::dot(ray, ray);
            ++all;
            seen += t <= 0 || glm::length(from + t * ray) > radius;
        }
    return static_cast<double>(seen) / all;
}

}  // namespace lightwalk::truth
