// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk::truth {

inline double luminance(glm::dvec3 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

inline double soft_knee(double luminance, double threshold, double knee) {
    const double w = knee * threshold, above = luminance - threshold;
    if (above >= w) return above;
    return above <= -w ? 0 : (above + w) * (above + w) / (4 * w);
}

/// NaN and below 0 become 0, above 65504 becomes 65504.
inline double finite_light(double x) { return std::isnan(x) ? 0 : std::clamp(x, 0.0, 65504.0); }
inline glm::dvec3 finite_light(glm::dvec3 c) { return {finite_light(c.r), finite_light(c.g), finite_light(c.b)}; }

inline glm::dvec3 bright_pass(glm::dvec3 radiance, double threshold, double knee) {
    const glm::dvec3 light = finite_light(radiance);
    const double l = luminance(light);
    return l > 0 ? light * (soft_knee(l, threshold, knee) / l) : glm::dvec3(0);
}

/// Loss of a Gaussian cut off at t sigma in both directions: 1 - erf(t / √2)²; for a disc of that radius exp(-t² / 2).
inline double lost_outside_square(double t) { return 1 - std::pow(std::erf(t / std::sqrt(2.0)), 2); }
inline double lost_outside_disc(double t) { return std::exp(-0.5 * t * t); }

struct Field {
    int width = 1, height = 1;
    std::vector<double> values;
    double at(int x, int y) const { return values[static_cast<size_t>(y * width + x)]; }
};

enum class Border { clamp, mirror, black };

/// Where a texel outside is read, or -1 for black. Mirrored again and again.
inline int inside(int i, int size, Border border) {
    if (border == Border::clamp) return std::clamp(i, 0, size - 1);
    if (border == Border::black) return i < 0 || i >= size ? -1 : i;
    const int period = 2 * size, turn = ((i % period) + period) % period;
    return turn < size ? turn : period - 1 - turn;
}

/// The field under a two-dimensional Gaussian of `sigma` pixels out to 6 sigma: a double sum over a square, its weights
/// as they are at the pixels' middles, divided by their sum.
inline Field blur(const Field& field, double sigma, Border border = Border::clamp) {
    if (sigma == 0) return field;
    const int radius = static_cast<int>(std::ceil(6 * sigma));
    Field result{field.width, field.height, {}};
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            double sum = 0, weights = 0;
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i) {
                    const double weight = std::exp(-0.5 * (i * i + j * j) / (sigma * sigma));
                    const int u = inside(x + i, field.width, border), v = inside(y + j, field.height, border);
                    weights += weight;
                    if (u >= 0 && v >= 0) sum += weight * field.at(u, v);
                }
            result.values.push_back(sum / weights);
        }
    return result;
}

}  // namespace lightwalk::truth
