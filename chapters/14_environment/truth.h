// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "04_surface_maps/truth.h"

namespace lightwalk::truth {

constexpr double around = 6.28318530717958647693;  ///< a whole turn, in radians

/// Texture coordinates of a direction in an equirectangular picture centred on -z; (1/2, 0) and (1/2, 1) at the
/// poles.
inline glm::dvec2 equirect(glm::dvec3 d) {
    const double across = std::hypot(d.x, d.z);
    return {across > 0 ? 0.5 + std::atan2(d.x, -d.z) / around : 0.5, std::atan2(across, d.y) / (0.5 * around)};
}

/// Direction of a point in that picture: unit length.
inline glm::dvec3 direction_at(glm::dvec2 uv) {
    const double phi = (uv.x - 0.5) * around, theta = 0.5 * around * uv.y;
    return {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)};
}

/// Steradians of a texel in a row of an equirectangular picture.
inline double equirect_solid_angle(int row, int width, int height) {
    const double high = 0.5 * around / height;
    return around / width * (std::cos(row * high) - std::cos((row + 1) * high));
}

/// The real spherical harmonics up to degree 2 of a direction of unit length, in the order of Sh9.
inline std::vector<double> harmonics(glm::dvec3 d) {
    const double pi = 0.5 * around, c0 = 0.5 * std::sqrt(1 / pi), c1 = std::sqrt(0.75 / pi);
    const double c2 = 0.5 * std::sqrt(15 / pi), c20 = 0.25 * std::sqrt(5 / pi);
    return {c0,
            c1 * d.y,
            c1 * d.z,
            c1 * d.x,
            c2 * d.x * d.y,
            c2 * d.y * d.z,
            c20 * (3 * d.z * d.z - 1),
            c2 * d.x * d.z,
            0.5 * c2 * (d.x * d.x - d.y * d.y)};
}

/// Irradiance over pi from nine coefficients of radiance: the cosine lobe's factors are 1, 2/3 and 1/4.
inline double sh_irradiance(const std::vector<double>& coefficients, glm::dvec3 normal) {
    const std::vector<double> basis = harmonics(normal);
    double sum = 0;
    for (size_t i = 0; i < 9; ++i) sum += (i == 0 ? 1.0 : i < 4 ? 2.0 / 3 : 0.25) * coefficients[i] * basis[i];
    return sum;
}

/// Light reflected to the eye by a surface with Schlick's Fresnel under radiance `light(l)`, by a sum over `steps`²
/// half vectors with density D n·h: single scattering alone.
inline double reflected(double n_dot_v, double alpha, double f0, const std::function<double(glm::dvec3)>& light,
                        int steps = 512) {
    const glm::dvec3 v(std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double x = (i + 0.5) / steps, phi = around * (j + 0.5) / steps;
            const double c2 = (1 - x) / (1 + (alpha * alpha - 1) * x), s = std::sqrt(1 - c2);
            const glm::dvec3 h(s * std::cos(phi), s * std::sin(phi), std::sqrt(c2));
            const double vh = glm::dot(v, h);
            const glm::dvec3 l = 2 * vh * h - v;
            if (l.z <= 0 || vh <= 0) continue;
            const double fresnel = f0 + (1 - f0) * std::pow(1 - vh, 5);
            sum += light(l) * fresnel * ggx_visibility(l.z, n_dot_v, alpha) * l.z * 4 * vh / h.z;
        }
    return sum / (double(steps) * steps);
}

}  // namespace lightwalk::truth
