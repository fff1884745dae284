// Closed forms of this chapter in double precision. For tone curves see tone_truth.h and aces_truth.h.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace lightwalk::truth {

inline double luminance_of(glm::dvec3 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

inline glm::dvec3 apply_gamma(glm::dvec3 c, double gamma) {
    return gamma > 0 ? glm::pow(glm::max(c, glm::dvec3(0)), glm::dvec3(1 / gamma)) : c;
}

inline glm::dvec3 contrast(glm::dvec3 c, double amount) {
    return 0.18 * glm::pow(glm::max(c, glm::dvec3(0)) / 0.18, glm::dvec3(amount));  // pow(0, 0) is 1 in C++
}

inline glm::dvec3 saturate_color(glm::dvec3 c, double amount) {
    return glm::max(glm::mix(glm::dvec3(luminance_of(c)), c, amount), glm::dvec3(0));
}

inline double vignette(glm::dvec2 uv, double aspect, double strength, double power) {
    const double r = std::hypot((uv.x - 0.5) * aspect, uv.y - 0.5) / std::hypot(0.5 * aspect, 0.5);
    return 1 - strength * std::pow(r, power);
}

inline glm::dvec2 aberrated(glm::dvec2 uv, double shift) {
    const glm::dvec2 away = uv - 0.5;
    return 0.5 + away * (1 + shift * glm::dot(away, away) / 0.5) / (1 + std::max(shift, 0.0));
}

/// The recursion as Bayer wrote it, row y and column x of B(bits).
inline int bayer_rank(int x, int y, int bits) {
    if (bits == 0) return 0;
    const int half = 1 << (bits - 1), quadrant[2][2] = {{0, 2}, {3, 1}};
    return 4 * bayer_rank(x % half, y % half, bits - 1) + quadrant[y / half][x / half];
}

inline double circle_of_confusion(double z, double focus, double focal, double f_number, double sensor,
                                  double height_px, double most_px) {
    const double f = std::max(focus, 1.01 * focal);
    const double disc = focal / f_number * (1 - f / z) * focal / (f - focal);
    return std::clamp(disc / sensor * height_px, -most_px, most_px);
}

inline double histogram_position(double luminance) {  // 0 at 2^-12, 255 at 2^12
    return (std::log2(luminance) + 12) * 255 / 24;
}

inline double encode_srgb(double c) {
    c = std::clamp(c, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}
inline double decode_srgb(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

}  // namespace lightwalk::truth
