// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "12_skin/profile.h"

namespace lightwalk::truth {

constexpr double skin_pi = 3.14159265358979323846;

inline glm::dvec3 profile(double r_mm) {
    glm::dvec3 sum(0);
    for (size_t i = 0; i < SKIN_GAUSSIANS; ++i) {
        const double v = double(skin_variance_mm2[i]);
        sum += glm::dvec3(skin_weight[i]) * std::exp(-0.5 * r_mm * r_mm / v) / (2 * skin_pi * v);
    }
    return sum;
}

inline glm::dvec3 transmittance(double thickness_mm) {
    const double s = std::max(thickness_mm, 0.0);
    glm::dvec3 sum(0);
    for (size_t i = 0; i < SKIN_GAUSSIANS; ++i)
        sum += glm::dvec3(skin_weight[i]) * std::exp(-s * s / double(skin_variance_mm2[i]));
    return sum;
}

inline double beckmann(double n_dot_h, double m) {
    if (n_dot_h <= 0) return 0;
    const double c2 = n_dot_h * n_dot_h, tan2 = (1 - c2) / c2, exponent = tan2 / (m * m);
    return exponent > 700 ? 0 : std::exp(-exponent) / (skin_pi * m * m * c2 * c2);
}

inline double schlick(double cosine, double f0) {
    return f0 + (1 - f0) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}

/// Times the cosine to the light, in 1/sr.
inline double kelemen_szirmay_kalos(glm::dvec3 n, glm::dvec3 l, glm::dvec3 v, double m, double f0) {
    const glm::dvec3 sum = l + v;
    const double square = glm::dot(sum, sum);
    if (glm::dot(n, l) <= 0 || glm::dot(n, v) <= 0 || square == 0) return 0;
    const glm::dvec3 h = sum / std::sqrt(square);
    return glm::dot(n, l) * beckmann(glm::dot(n, h), m) * schlick(glm::dot(v, h), f0) / square;
}

/// Reflected share of light from a direction: the integral of the BRDF times the cosine over the hemisphere, by a sum
/// over `steps` times four times as many directions. m above about 0.1: a sharper lobe falls between them.
inline double reflected(double cosine, double m, double f0, int steps = 400) {
    const glm::dvec3 n(0, 0, 1), v(std::sqrt(1 - cosine * cosine), 0, cosine);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 4 * steps; ++j) {
            const double z = (i + 0.5) / steps, r = std::sqrt(1 - z * z), a = 2 * skin_pi * (j + 0.5) / (4 * steps);
            sum += kelemen_szirmay_kalos(n, {r * std::cos(a), r * std::sin(a), z}, v, m, f0);
        }
    return sum * 2 * skin_pi / (4.0 * steps * steps);
}

/// A texel of the map: position in mm, area in mm², entering light; chart 0 is none.
struct SkinTexel {
    glm::dvec3 place_mm{0}, light{0};
    double area_mm2 = 0;
    int chart = 0;
};

/// Diffused light of a texel of a square map: the sum over all texels, each Gaussian's weights divided by their sum.
inline glm::dvec3 diffused(const std::vector<SkinTexel>& map, size_t at) {
    glm::dvec3 all(0);
    for (size_t i = 0; i < SKIN_GAUSSIANS; ++i) {
        glm::dvec3 sum(0);
        double weights = 0;
        for (const SkinTexel& other : map) {
            const glm::dvec3 apart = other.place_mm - map[at].place_mm;
            const double square = glm::dot(apart, apart);
            if (other.chart != map[at].chart || square > 81) continue;
            const double weight = other.area_mm2 * std::exp(-0.5 * square / double(skin_variance_mm2[i]));
            sum += weight * other.light;
            weights += weight;
        }
        all += glm::dvec3(skin_weight[i]) * (weights > 0 ? sum / weights : map[at].light);
    }
    return all;
}

}  // namespace lightwalk::truth
