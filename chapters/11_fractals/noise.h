// The terrain's noise in double precision, for the camera that follows the ground.
#pragma once
#include <algorithm>
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

/// The height at a settled place, -1 to 1.
inline double noise_height(glm::ivec2 cell, glm::dvec2 f) {
    const auto corner = [&](int x, int y) {
        return lattice(glm::ivec2(glm::uvec2(cell) + glm::uvec2(glm::ivec2(x, y))));
    };
    const glm::dvec2 s = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    return glm::mix(glm::mix(corner(0, 0), corner(1, 0), s.x), glm::mix(corner(0, 1), corner(1, 1), s.x), s.y);
}

/// The height of a sum of octaves as 11.eroded_fbm says it, within a millionth: gradients are differences, which in
/// double precision will do for a camera.
inline double eroded_height(NoisePlace place, double octaves, double erosion, double gain) {
    const auto at = [&](double x, double y) {
        NoisePlace there{place.cell, place.offset + glm::dvec2(x, y)};
        there.settle();
        return noise_height(there.cell, there.offset);
    };
    constexpr double h = 1e-4;
    glm::dvec2 steepness(0);
    double height = 0, amplitude = 1;
    for (int k = 0; k < octaves; ++k) {
        place.settle();
        const double share = std::min(octaves - k, 1.0);
        steepness += share / (2 * h) * glm::dvec2(at(h, 0) - at(-h, 0), at(0, h) - at(0, -h));
        height += amplitude * share * at(0, 0) / (1 + erosion * glm::dot(steepness, steepness));
        place.next();
        amplitude *= gain;
    }
    return height;
}

}  // namespace lightwalk
