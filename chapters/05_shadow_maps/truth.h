// References of this chapter, in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace lightwalk::truth {

inline glm::dvec3 light_clip_position(const glm::dmat4& to_clip, glm::dvec3 position) {
    const glm::dvec4 clip = to_clip * glm::dvec4(position, 1.0);
    if (clip.w <= 0) return glm::dvec3(-1);
    return {0.5 + 0.5 * clip.x / clip.w, 0.5 + 0.5 * clip.y / clip.w, clip.z / clip.w};
}

inline double compare_depth(glm::dvec3 place, double stored) {
    const bool outside = place.x < 0 || place.x > 1 || place.y < 0 || place.y > 1;
    return outside || place.z >= stored ? 1 : 0;
}

inline double slope_bias(double cosine, double texel, double reach) {
    const double angle = std::acos(std::clamp(cosine, 0.025, 1.0));
    return std::sqrt(2.0) * reach * texel * std::tan(angle);
}

/// The maps of tests/05_shadow_maps/known_map.glsl's FIELD, 64 texels wide.
inline double field_depth(int field, int x, int y) {
    if (x < 0 || y < 0 || x >= 64 || y >= 64) return 0;
    if (field == 1) return x < 32 ? 0.75 : 0.25;
    if (field == 2) return 0.5 + 0.3 * ((x + 0.5) / 64 - 0.5) - 0.2 * ((y + 0.5) / 64 - 0.5);
    return (x * 7 + y * 13) % 5 < 2 ? 0.75 : 0.25;
}

/// The lit part of the square, texel by texel, each by the area that the square covers of it.
inline double pcf(int field, glm::dvec2 uv, double depth, glm::dvec2 slope, int kernel) {
    const glm::dvec2 begin = 64.0 * uv - 0.5 * kernel, end = begin + double(kernel);
    double lit = 0;
    for (int y = int(std::floor(begin.y)); y < end.y; ++y)
        for (int x = int(std::floor(begin.x)); x < end.x; ++x) {
            const double area = (std::min(end.x, x + 1.0) - std::max(begin.x, double(x))) *
                                (std::min(end.y, y + 1.0) - std::max(begin.y, double(y)));
            const double plane = depth + glm::dot(slope, (glm::dvec2(x, y) + 0.5) / 64.0 - uv);
            if (std::max(plane, 0.0) >= field_depth(field, x, y)) lit += area;
        }
    return lit / (kernel * kernel);
}

inline double chebyshev(glm::dvec2 moments, double depth, double least) {
    if (depth <= moments.x) return 1;
    const double variance = std::max(moments.y - moments.x * moments.x, least);
    return variance / (variance + (depth - moments.x) * (depth - moments.x));
}

inline double penumbra_width(double receiver, double blocker, double size, bool parallel) {
    const double from = parallel ? blocker : std::max(blocker, 1e-3), gap = std::max(receiver - from, 0.0);
    return parallel ? size * gap : size * gap / from;
}

inline double cascade_split(double near_m, double far_m, int i, int count, double lambda) {
    const double t = double(i) / count;
    return (1 - lambda) * (near_m + (far_m - near_m) * t) + lambda * near_m * std::pow(far_m / near_m, t);
}

}  // namespace lightwalk::truth
