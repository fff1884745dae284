// Double-precision references: one pixel's transparent layers, mixed by each method.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk::truth {

/// Of one pixel: `z_m` along the view; `depth` 0 at the near plane and 1 at the far plane.
struct Layer {
    glm::dvec3 color;
    double alpha, z_m, depth;
};

/// Each over those before it in the list.
inline glm::dvec3 over(const std::vector<Layer>& layers, glm::dvec3 background) {
    for (const Layer& layer : layers) background = glm::mix(background, layer.color, layer.alpha);
    return background;
}

/// Back to front.
inline glm::dvec3 in_order(std::vector<Layer> layers, const glm::dvec3& background) {
    std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.z_m > b.z_m; });
    return over(layers, background);
}

/// As exercise 15.wboit_weight says.
inline double wboit_weight(int equation, double alpha, double z_m, double depth) {
    double x = 3000 * std::pow(1 - depth, 3);
    if (equation == 0) return 1;
    if (equation == 1) x = 10 / (1e-5 + std::pow(z_m / 5, 2) + std::pow(z_m / 200, 6));
    if (equation == 2) x = 10 / (1e-5 + std::pow(z_m / 10, 3) + std::pow(z_m / 200, 6));
    if (equation == 3) x = 0.03 / (1e-5 + std::pow(z_m / 200, 4));
    return alpha * std::clamp(x, 0.01, 3000.0);
}

inline glm::dvec3 weighted(const std::vector<Layer>& layers, const glm::dvec3& background, int equation) {
    glm::dvec3 sum(0);
    double weights = 0, behind = 1;
    for (const Layer& l : layers) {
        const double w = l.alpha * wboit_weight(equation, l.alpha, l.z_m, l.depth);
        sum += w * l.color, weights += w, behind *= 1 - l.alpha;
    }
    return glm::mix(sum / std::max(weights, 1e-5), background, behind);
}

/// Transmittance before `z` by four power moments: the distribution with mass at z and at two other depths that has them.
/// By Newton's form of the parabola, in another order than the shader's.
inline double moment_transmittance(glm::dvec4 b, double all, double z, double bias, double overestimation) {
    b = glm::mix(b, glm::dvec4(0, 0.375, 0, 0.375), bias);
    const glm::dmat3 hankel(glm::dvec3(1, b.x, b.y), glm::dvec3(b.x, b.y, b.z), glm::dvec3(b.y, b.z, b.w));
    const glm::dvec3 c = glm::inverse(hankel) * glm::dvec3(1, z, z * z);
    const double root = std::sqrt(std::max(c.y * c.y - 4 * c.z * c.x, 0.0));
    const double t[] = {z, (-c.y - root) / (2 * c.z), (-c.y + root) / (2 * c.z)};
    // Masses at the three depths: they have the moments 1, b1 and b2.
    const glm::dmat3 powers(glm::dvec3(1, t[0], t[0] * t[0]), glm::dvec3(1, t[1], t[1] * t[1]),
                            glm::dvec3(1, t[2], t[2] * t[2]));
    const glm::dvec3 mass = glm::inverse(powers) * glm::dvec3(1, b.x, b.y);
    const double before = overestimation * mass[0] + (t[1] < z ? mass[1] : 0) + (t[2] < z ? mass[2] : 0);
    return std::clamp(std::exp(-all * before), 0.0, 1.0);
}

inline glm::dvec3 by_moments(const std::vector<Layer>& layers, const glm::dvec3& background, double near_m,
                             double far_m, double bias = 5e-7, double overestimation = 0.25) {
    const auto depth = [&](const Layer& l) { return 2 * std::log(l.z_m / near_m) / std::log(far_m / near_m) - 1; };
    glm::dvec4 b(0);
    double all = 0;
    for (const Layer& l : layers) {
        const double a = -std::log(std::max(1 - l.alpha, 9.5e-7)), z = depth(l);
        all += a, b += a * glm::dvec4(z, z * z, z * z * z, z * z * z * z);
    }
    glm::dvec3 sum(0);
    double weights = 0;
    for (const Layer& l : layers) {
        const double w = l.alpha * moment_transmittance(b / all, all, depth(l), bias, overestimation);
        sum += w * l.color, weights += w;
    }
    const double behind = std::exp(-all);
    return behind * background + (1 - behind) * sum / std::max(weights, 1e-5);
}

}  // namespace lightwalk::truth
