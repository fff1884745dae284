// References of this chapter, in double precision.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "common/scene/light.h"

namespace lightwalk::truth {

inline double one_sign(double x) { return x < 0.0 ? -1.0 : 1.0; }

/// The octahedron's square folded along its inner diamond: outer points come inside, and back.
inline glm::dvec2 fold(glm::dvec2 e) {
    return {(1.0 - std::fabs(e.y)) * one_sign(e.x), (1.0 - std::fabs(e.x)) * one_sign(e.y)};
}

inline glm::dvec2 encode_normal(glm::dvec3 n) {
    const glm::dvec2 e = glm::dvec2(n) / (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
    return n.z < 0.0 ? fold(e) : e;
}

inline glm::dvec3 decode_normal(glm::dvec2 e) {
    const double z = 1.0 - std::fabs(e.x) - std::fabs(e.y);
    return glm::normalize(glm::dvec3(z < 0.0 ? fold(e) : e, z));
}

/// Each number in `bits` bits, so that -1, 0 and 1 come back exactly.
inline glm::dvec2 quantised(glm::dvec2 e, int bits) {
    const double most = (1 << (bits - 1)) - 1;
    return glm::round(e * most) / most;
}

/// Degrees between two unit vectors; exact for small angles too.
inline double angle_deg(glm::dvec3 a, glm::dvec3 b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

inline glm::dvec3 position_from_depth(glm::dvec2 pixel, double depth, glm::dvec2 size,
                                      const glm::dmat4& clip_to_world) {
    const glm::dvec4 world = clip_to_world * glm::dvec4(2.0 * (pixel + 0.5) / size - 1.0, depth, 1.0);
    return glm::dvec3(world) / world.w;
}

/// Above 0 the triangle faces away from the eye, which is the origin; 0: it is seen from the edge, or has no area.
inline double faces_away(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, bool mirrored) {
    return (mirrored ? -1.0 : 1.0) * glm::dot(glm::cross(b - a, c - a), a);
}

constexpr double most_shininess = 8192.0;

/// The eight codes before they are rounded: diffuse rgb, gloss, specular rgb (each 0 to 255), occlusion (0 to 127).
inline std::array<double, 8> material_codes(glm::dvec3 diffuse, glm::dvec3 specular, double shininess,
                                            double occlusion) {
    const auto color = [](double c) { return 255.0 * std::sqrt(std::clamp(c, 0.0, 1.0)); };
    return {color(diffuse.r),
            color(diffuse.g),
            color(diffuse.b),
            255.0 * std::log2(1.0 + std::clamp(shininess, 0.0, most_shininess)) / std::log2(1.0 + most_shininess),
            color(specular.r),
            color(specular.g),
            color(specular.b),
            127.0 * std::clamp(occlusion, 0.0, 1.0)};
}

/// The volume in m³ of the smaller of the two shapes around a light's reach.
inline double least_volume(const Light& light, double radius_m) {
    const double ball = 4.0 / 3.0 * 3.141592653589793 * std::pow(radius_m, 3.0), half = double(light.outer_rad);
    if (light.kind != Light::Kind::spot || half >= 1.57) return ball;
    return std::min(ball, ball * std::pow(std::tan(half), 2.0) / 4.0);
}

/// The eight corners of a box.
inline std::array<glm::dvec3, 8> corners(glm::dvec3 center, glm::dvec3 half_size) {
    std::array<glm::dvec3, 8> all;
    for (int i = 0; i < 8; ++i)
        all[size_t(i)] = center + half_size * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    return all;
}

/// The greatest dot(plane, (p, 1)) of a box's points: below 0 all of it is behind the plane.
inline double most_in_front(glm::dvec3 center, glm::dvec3 half_size, glm::dvec4 plane) {
    double most = -1e300;
    for (const glm::dvec3& corner : corners(center, half_size))
        most = std::max(most, glm::dot(plane, glm::dvec4(corner, 1.0)));
    return most;
}

/// The smallest level in which pixels low to high lie in two texels at most along each axis.
inline int pyramid_level(glm::ivec2 low, glm::ivec2 high) {
    for (int level = 0;; ++level) {
        const int texel = 1 << level;
        if (high.x / texel - low.x / texel < 2 && high.y / texel - low.y / texel < 2) return level;
    }
}

/// low, high and nearest, as the exercise screen_box specifies them.
inline std::array<double, 5> screen_box(glm::dvec3 center, glm::dvec3 half_size, const glm::dmat4& to_clip,
                                        glm::dvec2 size) {
    glm::dvec2 low(1e300), high(-1e300);
    double nearest = 0;
    for (const glm::dvec3& corner : corners(center, half_size)) {
        const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1.0);
        if (clip.z > clip.w) return {0, 0, size.x, size.y, 1};
        const glm::dvec2 at = (0.5 + 0.5 * glm::dvec2(clip) / clip.w) * size;
        low = glm::min(low, at);
        high = glm::max(high, at);
        nearest = std::max(nearest, clip.z / clip.w);
    }
    return {low.x, low.y, high.x, high.y, nearest};
}

}  // namespace lightwalk::truth
