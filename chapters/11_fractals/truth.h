// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "11_fractals/noise.h"

namespace lightwalk::truth {

/// Hamilton's product of a = (real, i, j, k) and b.
inline glm::dvec4 product(glm::dvec4 a, glm::dvec4 b) {
    return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
            a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y, a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x};
}

/// The bound .25 sqrt(|z|² / |z'|²) log |z|² after the turn in which |z| exceeds `escape`; 0 where it never does, or
/// where |z'|² exceeds 1e30; .05 where z' is 0.
inline double julia_distance(glm::dvec4 z, glm::dvec4 c, int iterations, double escape) {
    double square = glm::dot(z, z), slope_square = 1;
    for (int i = 0; i < iterations && square <= escape * escape; ++i) {
        slope_square *= 4 * square;
        if (slope_square > 1e30) return 0;
        z = product(z, z) + c;
        square = glm::dot(z, z);
    }
    if (square <= escape * escape) return 0;
    return slope_square > 0 ? 0.25 * std::sqrt(square / slope_square) * std::log(square) : 0.05;
}

/// Whether a point stays within |z| <= 2 + |c| for so many turns: taken for one of the set.
inline bool in_julia(glm::dvec4 z, glm::dvec4 c, int iterations) {
    const double bound = 2 + glm::length(c);
    for (int i = 0; i < iterations; ++i) {
        if (glm::dot(z, z) > bound * bound) return false;
        z = product(z, z) + c;
    }
    return true;
}

/// The direction in which |z| grows, after the turn in which it exceeds `escape`: the chain rule, of z² by z, for the
/// first three components of z. Unit length; 0 where it never escapes.
inline glm::dvec3 julia_normal(glm::dvec4 z, glm::dvec4 c, int iterations, double escape) {
    glm::dvec4 by[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    for (int i = 0; i <= iterations; ++i) {
        if (glm::dot(z, z) > escape * escape) {
            const glm::dvec3 gradient(glm::dot(z, by[0]), glm::dot(z, by[1]), glm::dot(z, by[2]));
            return glm::normalize(gradient);
        }
        const double scale = 1 / std::max(2 * glm::length(z), 1e-300);
        for (glm::dvec4& change : by) change = scale * (product(z, change) + product(change, z));
        z = product(z, z) + c;
    }
    return glm::dvec3(0);
}

/// How a ray is marched in double precision: by small shares of a bound that is itself far from the set's edge.
struct JuliaRay {
    glm::dvec4 c;
    double slice = 0;
    int iterations = 200;
    double escape = 64, share = 0.2, near_enough = 1e-6;
    int most_steps = 20000;
};

/// Metres to the set along a ray (`along` of unit length) between two distances, or -1 where it passes by. The last
/// step is halved until the place where the bound falls below `near_enough` is known to 1e-9.
inline double julia_depth(const JuliaRay& ray, glm::dvec3 from, glm::dvec3 along, double start, double end) {
    const auto bound_at = [&](double t) {
        return julia_distance({from + t * along, ray.slice}, ray.c, ray.iterations, ray.escape);
    };
    double t = start, before = start;
    for (int i = 0; i < ray.most_steps && t < end; ++i) {
        const double distance = bound_at(t);
        if (distance <= ray.near_enough) {
            for (double low = before, high = t;;) {
                const double middle = 0.5 * (low + high);
                if (high - low < 1e-9) return high;
                (bound_at(middle) <= ray.near_enough ? high : low) = middle;
            }
        }
        before = t;
        t += std::max(ray.share * distance, 1e-9);
    }
    return -1;
}

/// Where a ray is within a ball around the origin: metres; the second is below the first where it passes by.
inline glm::dvec2 within_ball(glm::dvec3 from, glm::dvec3 along, double radius) {
    const double middle = -glm::dot(from, along);
    const glm::dvec3 beside = from + middle * along;
    const double square = radius * radius - glm::dot(beside, beside);
    if (square <= 0) return {0, -1};
    return {std::max(middle - std::sqrt(square), 0.0), middle + std::sqrt(square)};
}

/// As 11.integrate_octaves says it.
inline double integrate_octaves(double first_m, double lacunarity, double footprint_m, double most) {
    if (footprint_m <= 0) return most;
    return std::clamp(std::log(first_m / (2 * footprint_m)) / std::log(lacunarity) + 1, 1.0, most);
}

/// As 11.terrain_mix says it.
inline double terrain_mix(double normal_y, double roughness, glm::dvec2 lower, glm::dvec2 upper, double strength) {
    const double begins = lower.x - lower.y * normal_y, ends = upper.x - upper.y * normal_y, at = strength * roughness;
    if (begins >= ends) return at >= begins ? 1 : 0;
    const double t = std::clamp((at - begins) / (ends - begins), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Height, gradient and second derivatives (xx, xy, yy) at a settled place. `cubic`: by 3 t² - 2 t³ instead of the
/// quintic.
struct NoiseTruth {
    double value;
    glm::dvec2 gradient;
    glm::dvec3 second;
};

inline NoiseTruth noise_truth(glm::ivec2 cell, glm::dvec2 f, bool cubic = false) {
    const auto corner = [&](int x, int y) {
        return lattice(glm::ivec2(glm::uvec2(cell) + glm::uvec2(glm::ivec2(x, y))));
    };
    const double a = corner(0, 0), b = corner(1, 0) - a, c = corner(0, 1) - a,
                 d = a - corner(1, 0) - corner(0, 1) + corner(1, 1);
    glm::dvec2 s, first, second;
    for (int i = 0; i < 2; ++i) {
        const double t = f[i];
        s[i] = cubic ? t * t * (3 - 2 * t) : t * t * t * (t * (6 * t - 15) + 10);
        first[i] = cubic ? 6 * t * (1 - t) : 30 * t * t * (t - 1) * (t - 1);
        second[i] = cubic ? 6 - 12 * t : 60 * t * (2 * t * t - 3 * t + 1);
    }
    return {a + b * s.x + c * s.y + d * s.x * s.y,
            {first.x * (b + d * s.y), first.y * (c + d * s.x)},
            {second.x * (b + d * s.y), d * first.x * first.y, second.y * (c + d * s.x)}};
}

/// Height and its derivatives by octave 0's coordinates, as 11.eroded_fbm says it.
struct Ground {
    double height = 0;
    glm::dvec2 slope{0};       ///< the whole chain rule
    glm::dvec2 sum{0};         ///< d, which some take for the slope
    glm::dvec2 unweighted{0};  ///< the slope without the weight's own derivative
};

inline Ground eroded_truth(NoisePlace place, double octaves, double erosion, double gain) {
    Ground ground;
    glm::dmat2 scale(1), bend(0);
    const glm::dmat2 finer(2, 1, -1, 2);
    double amplitude = 1;
    for (int k = 0; k < octaves; ++k) {
        place.settle();
        const NoiseTruth noise = noise_truth(place.cell, place.offset);
        const double share = std::min(octaves - k, 1.0);
        ground.sum += share * noise.gradient;
        bend += share * (glm::dmat2(noise.second.x, noise.second.y, noise.second.y, noise.second.z) * scale);
        const double weight = 1 / (1 + erosion * glm::dot(ground.sum, ground.sum));
        const glm::dvec2 down = glm::transpose(scale) * noise.gradient * weight;
        const glm::dvec2 weight_slope = -2 * erosion * weight * weight * (glm::transpose(bend) * ground.sum);
        ground.height += amplitude * share * noise.value * weight;
        ground.unweighted += amplitude * share * down;
        ground.slope += amplitude * share * (down + noise.value * weight_slope);
        place.next();
        scale = finer * scale;
        amplitude *= gain;
    }
    return ground;
}

}  // namespace lightwalk::truth
