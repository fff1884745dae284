// References of this chapter in double precision.
#pragma once
#include <cmath>

#include "07_mipmaps/texels.h"

namespace lightwalk::truth {

/// Texels of a row of `from` under texel i of a row of `to`, and the covered share of each.
struct Span {
    uint32_t first = 0;
    std::vector<double> shares;
};

inline Span span(uint32_t i, uint32_t from, uint32_t to) {
    // In integers, units of 1 / (from * to) of the row, so that nothing is rounded.
    const uint64_t begin = uint64_t(i) * from, end = begin + from;
    Span result{static_cast<uint32_t>(begin / to), {}};
    for (uint64_t j = result.first; j * to < end; ++j)
        result.shares.push_back(static_cast<double>(std::min(end, (j + 1) * to) - std::max(begin, j * to)) /
                                static_cast<double>(from));
    return result;
}

/// Mean over each texel's area of an image of `size`: the integral of `from` as squares of one value, in double
/// precision.
inline Texels area_mean(const Texels& from, glm::uvec2 size) {
    Texels rows{{from.size.x, size.y}, {}}, result{size, {}};
    rows.values.reserve(size_t(from.size.x) * size.y);
    for (uint32_t y = 0; y < size.y; ++y) {
        const Span down = span(y, from.size.y, size.y);
        for (uint32_t x = 0; x < from.size.x; ++x) {
            glm::dvec4 sum(0);
            for (uint32_t k = 0; k < down.shares.size(); ++k) sum += down.shares[k] * from.at(x, down.first + k);
            rows.values.push_back(sum);
        }
    }
    result.values.reserve(size_t(size.x) * size.y);
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const Span across = span(x, from.size.x, size.x);
            glm::dvec4 sum(0);
            for (uint32_t k = 0; k < across.shares.size(); ++k) sum += across.shares[k] * rows.at(across.first + k, y);
            result.values.push_back(sum);
        }
    return result;
}

inline double srgb_to_linear(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

inline double linear_to_srgb(double linear) {
    linear = std::clamp(linear, 0.0, 1.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline glm::dvec3 normal_to_linear(glm::dvec4 code) {
    const glm::dvec3 n = 2.0 * glm::dvec3(code) - 1.0;
    return (glm::dot(n, n) > 1e-12 ? glm::normalize(n) : glm::dvec3(0, 0, 1)) * (1 - code.a * code.a);
}

inline glm::dvec4 normal_from_linear(glm::dvec3 mean) {
    const double length = glm::length(mean);
    const glm::dvec3 n = length > 1e-4 ? mean / length : glm::dvec3(0, 0, 1);
    return {0.5 + 0.5 * n, std::sqrt(std::max(1 - length, 0.0))};
}

/// Decodes a texel into values that may be averaged.
inline glm::dvec4 decode(Content content, glm::dvec4 texel) {
    glm::dvec4 light = texel;
    for (int i = 0; i < 3; ++i) light[i] = srgb_to_linear(texel[i]);
    switch (content) {
        case Content::srgb:
            return light;
        case Content::cutout:
            return {glm::dvec3(light) * texel.a, texel.a};
        case Content::normal:
            return {normal_to_linear(texel), 1};
        case Content::roughness:
            return {texel.r, std::pow(texel.g, 4), texel.b, texel.a};
        default:
            return texel;
    }
}

/// Encodes a mean with all digits.
inline glm::dvec4 encode(Content content, glm::dvec4 mean) {
    glm::dvec3 light(mean);
    if (content == Content::cutout && mean.a > 0) light /= mean.a;
    for (int i = 0; i < 3; ++i) light[i] = linear_to_srgb(light[i]);
    switch (content) {
        case Content::srgb:
        case Content::cutout:
            return {light, mean.a};
        case Content::normal:
            return normal_from_linear(mean);
        case Content::roughness:
            return {mean.r, std::pow(mean.g, 0.25), mean.b, mean.a};
        default:
            return mean;
    }
}

/// How far a level is from the exact mean of the first, in the numbers that are averaged: the root of the mean square
/// over texels and channels, alpha left out.
inline double rmse(const Texels& exact, const Texels& found) {
    double sum = 0;
    for (size_t i = 0; i < exact.values.size(); ++i) {
        const glm::dvec3 off(exact.values[i] - found.values[i]);
        sum += glm::dot(off, off) / 3;
    }
    return std::sqrt(sum / static_cast<double>(exact.values.size()));
}

}  // namespace lightwalk::truth
