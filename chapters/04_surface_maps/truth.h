// References of this chapter, in double precision. Directions have unit length; tangent space has z along the normal.
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

namespace lightwalk::truth {

inline glm::dvec3 unpack_normal(glm::dvec2 code, double strength) {
    const glm::dvec2 xy = 2.0 * code - 1.0;
    const glm::dvec3 n(strength * xy, std::sqrt(std::max(0.0, 1.0 - glm::dot(xy, xy))));
    return glm::length(n) > 0 ? glm::normalize(n) : glm::dvec3(0, 0, 1);
}

/// The rotation that takes (0, 0, 1) to `base`, applied to `detail` (Rodrigues' formula).
inline glm::dvec3 blend_detail(glm::dvec3 base, glm::dvec3 detail) {
    const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), base);
    const double sine = glm::length(axis), cosine = base.z;
    if (sine < 1e-12) return detail;
    const glm::dvec3 k = axis / sine;
    return detail * cosine + glm::cross(k, detail) * sine + k * glm::dot(k, detail) * (1 - cosine);
}

inline glm::dvec2 parallax_offset(double depth, glm::dvec3 to_eye, glm::dvec2 deepest) {
    return -depth * deepest * glm::dvec2(to_eye) / to_eye.z;
}

inline glm::dvec2 parallax_offset_limited(double depth, glm::dvec3 to_eye, glm::dvec2 deepest) {
    return -depth * deepest * glm::dvec2(to_eye);
}

/// The fields of tests/04_surface_maps/known_field.glsl, by their number.
inline double field_depth(int field, double u) {
    if (field == 1) return u - std::floor(u);
    if (field == 2) return 0.5 + 0.5 * std::sin(6.2831853 * u);
    if (field == 3) return std::fabs(u - 0.5) < 1.0 / 512.0 ? 0.0 : 1.0;
    return 0.5;
}

/// Depths found by layers, and by the secant of the last step, in a field that depends on u alone.
inline double first_layer_below(int field, double u, double shift, int steps) {
    for (int i = 0; i < steps; ++i)
        if (double(i) / steps >= field_depth(field, u - double(i) / steps * shift)) return double(i) / steps;
    return 1;
}

inline double parallax_occlusion(int field, double u, double shift, int steps) {
    const double below = first_layer_below(field, u, shift, steps), above = below - 1.0 / steps;
    if (below <= 0) return 0;
    const double gap = field_depth(field, u - above * shift) - above;
    const double overlap = below - field_depth(field, u - below * shift);
    return above + (below - above) * gap / std::max(gap + overlap, 1e-6);
}

struct Mixed {
    glm::dvec3 diffuse, specular;
    double shininess;
};

inline Mixed mix_orm(glm::dvec3 base, double roughness, double metalness) {
    const double alpha = roughness * roughness;
    const double shininess = alpha > 0 ? std::min(2 / (alpha * alpha) - 2, 8192.0) : 8192.0;
    return {base * (1 - metalness), glm::mix(glm::dvec3(0.04), base, metalness), shininess};
}

}  // namespace lightwalk::truth
