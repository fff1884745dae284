// The terrain's noise in double precision: for the camera that follows the ground, and as this chapter's truth.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace lightwalk {

/// A place in an octave: a cell, and where in it.
struct NoisePlace {
    glm::ivec2 cell{0};
    glm::dvec2 offset{0};

    /// That of a coordinate in cells, exact as long as a double is.
    static NoisePlace at(glm::dvec2 cells) {
        const glm::dvec2 whole = glm::floor(cells);
        return {glm::ivec2(glm::u64vec2(glm::i64vec2(whole)) & uint64_t(0xffffffff)), cells - whole};
    }
    /// As settle() of lattice.glsl: offset to 0 to 1.
    void settle() {
        const glm::dvec2 whole = glm::floor(offset);
        cell = glm::ivec2(glm::uvec2(cell) + glm::uvec2(glm::ivec2(whole)));
        offset -= whole;
    }
    /// As next_octave() of lattice.glsl.
    void next() {
        const glm::uvec2 c(cell);
        cell = glm::ivec2(glm::uvec2(2u * c.x - c.y, c.x + 2u * c.y) + glm::uvec2(57, 113));
        offset = {2 * offset.x - offset.y, offset.x + 2 * offset.y};
    }
};

/// The number at whole coordinates, -1 to 1: lattice() of lattice.glsl.
inline double lattice(glm::ivec2 cell) {
    glm::uvec2 v = glm::uvec2(cell) * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        v.x += v.y * 1664525u;
        v.y += v.x * 1664525u;
        v ^= v >> 16u;
    }
    return (v.x >> 8u) * (2.0 / 16777215.0) - 1.0;
}

/// Height, gradient and second derivatives (xx, xy, yy) at a settled place. `cubic`: by 3 t² - 2 t³ in place of the
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

}  // namespace lightwalk
