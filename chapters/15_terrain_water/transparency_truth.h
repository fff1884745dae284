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
    glm::dvec3 tint{1.0};  ///< share of the light behind that passes where alpha lets it
};

/// Shares of light that pass one after another, multiplied: Beer and Lambert's law.
inline double passed_share(std::initializer_list<double> passed_alpha_tint) {
    const double* s = passed_alpha_tint.begin();
    return std::exp(std::log(s[0]) + std::log1p(-s[1]) + std::log(s[2]));
}

/// Each over those before it in the list.
inline glm::dvec3 over(const std::vector<Layer>& layers, glm::dvec3 background) {
    for (const Layer& layer : layers)
        background = layer.alpha * layer.color + (1 - layer.alpha) * layer.tint * background;
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

/// Tints filter the background; the surfaces' own light is mixed without them.
inline glm::dvec3 weighted(const std::vector<Layer>& layers, const glm::dvec3& background, int equation) {
    glm::dvec3 sum(0);
    double weights = 0, uncovered = 1;
    glm::dvec3 behind(1);
    for (const Layer& l : layers) {
        const double w = l.alpha * wboit_weight(equation, l.alpha, l.z_m, l.depth);
        sum += w * l.color;
        weights += w;
        uncovered *= 1 - l.alpha;
        behind *= (1 - l.alpha) * l.tint;
    }
    return (1 - uncovered) * sum / std::max(weights, 1e-5) + behind * background;
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

/// The same by six: mass at z and at the three roots of a cubic, found by halving between its turning points.
inline double moment_transmittance_6(glm::dvec4 b, glm::dvec2 high, double all, double z, double bias,
                                     double overestimation) {
    b = glm::mix(b, glm::dvec4(0, 0.48, 0, 0.451), bias);
    high = glm::mix(high, glm::dvec2(0, 0.45), bias);
    const glm::dmat4 hankel(glm::dvec4(1, b.x, b.y, b.z), glm::dvec4(b.x, b.y, b.z, b.w),
                            glm::dvec4(b.y, b.z, b.w, high.x), glm::dvec4(b.z, b.w, high.x, high.y));
    const glm::dvec4 c = glm::inverse(hankel) * glm::dvec4(1, z, z * z, z * z * z);
    const auto value = [&](double t) { return c.x + t * (c.y + t * (c.z + t * c.w)); };
    const double turn = std::sqrt(std::max(c.z * c.z - 3 * c.y * c.w, 0.0)), middle = -c.z / (3 * c.w);
    const double half = std::fabs(turn / (3 * c.w)), ends[] = {-1e3, middle - half, middle + half, 1e3};
    double t[4] = {z};
    for (int i = 0; i < 3; ++i) {
        double low = ends[i], high_end = ends[i + 1];
        for (int k = 0; k < 80; ++k) {
            const double at = 0.5 * (low + high_end);
            ((value(at) < 0) == (value(low) < 0) ? low : high_end) = at;
        }
        t[i + 1] = 0.5 * (low + high_end);
    }
    glm::dmat4 powers;
    for (int i = 0; i < 4; ++i) powers[i] = glm::dvec4(1, t[i], t[i] * t[i], t[i] * t[i] * t[i]);
    const glm::dvec4 mass = glm::inverse(powers) * glm::dvec4(1, b.x, b.y, b.z);
    double before = overestimation * mass[0];
    for (int i = 1; i < 4; ++i) before += t[i] < z ? mass[i] : 0;
    return std::clamp(std::exp(-all * before), 0.0, 1.0);
}

/// `six`: by six moments, else by four. Tints filter the background alone.
inline glm::dvec3 by_moments(const std::vector<Layer>& layers, const glm::dvec3& background, double near_m,
                             double far_m, bool six = false, double bias = 5e-7, double overestimation = 0.25) {
    const auto depth = [&](const Layer& l) { return 2 * std::log(l.z_m / near_m) / std::log(far_m / near_m) - 1; };
    glm::dvec4 b(0);
    glm::dvec2 high(0);
    double all = 0;
    for (const Layer& l : layers) {
        const double a = -std::log(std::max(1 - l.alpha, 9.5e-7)), z = depth(l);
        all += a;
        b += a * glm::dvec4(z, z * z, z * z * z, z * z * z * z);
        high += a * glm::dvec2(std::pow(z, 5), std::pow(z, 6));
    }
    glm::dvec3 sum(0), tint(1);
    double weights = 0;
    for (const Layer& l : layers) {
        tint *= l.tint;
        const double left = six ? moment_transmittance_6(b / all, high / all, all, depth(l), 10 * bias, overestimation)
                                : moment_transmittance(b / all, all, depth(l), bias, overestimation);
        const double w = l.alpha * left;
        sum += w * l.color;
        weights += w;
    }
    const double behind = std::exp(-all);
    return behind * tint * background + (1 - behind) * sum / std::max(weights, 1e-5);
}

/// Of layers in the order of the list the nearest four are kept, and two neighbours are merged, those farthest away, where
/// there is no room: multi-layer alpha blending (M. Salvi and K. Vaidyanathan, I3D 2014).
inline glm::dvec3 by_four_layers(const std::vector<Layer>& layers, const glm::dvec3& background) {
    struct Kept {
        double z_m;
        glm::dvec3 light;  ///< premultiplied
        double left;
    };
    std::vector<Kept> kept;
    for (const Layer& l : layers) {
        const auto after = std::find_if(kept.begin(), kept.end(), [&](const Kept& k) { return k.z_m > l.z_m; });
        kept.insert(after, {l.z_m, l.alpha * l.color, 1 - l.alpha});
        if (kept.size() <= 4) continue;
        Kept& nearer = kept[3];
        nearer.light += nearer.left * kept[4].light;
        nearer.left *= kept[4].left;
        kept.pop_back();
    }
    glm::dvec3 sum(0);
    double left = 1;
    for (const Kept& k : kept) {
        sum += left * k.light;
        left *= k.left;
    }
    return sum + left * background;
}

}  // namespace lightwalk::truth
