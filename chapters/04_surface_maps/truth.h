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

/// The end of a lamp's edge, or where the edge crosses the horizon.
inline glm::dvec3 above_horizon(glm::dvec3 end, glm::dvec3 other) {
    return end.z > 0 ? end : end + (other - end) * (end.z / (end.z - other.z));
}

/// The point of a ball nearest to a ray from the origin.
inline glm::dvec3 nearest_on_lamp(glm::dvec3 middle, double radius, glm::dvec3 mirrored) {
    const glm::dvec3 on_ray = std::max(0.0, glm::dot(middle, mirrored)) * mirrored, way = on_ray - middle;
    return glm::length(way) <= radius ? on_ray : middle + radius * glm::normalize(way);
}

/// GGX: the density of half vectors, per steradian.
inline double ggx_density(double n_dot_h, double alpha) {
    const double d = n_dot_h * n_dot_h * (alpha * alpha - 1) + 1;
    return alpha * alpha / (3.14159265358979323846 * d * d);
}

/// Smith's height-correlated masking and shadowing over 4 n·l n·v.
inline double ggx_visibility(double n_dot_l, double n_dot_v, double alpha) {
    const double a = alpha * alpha;
    return 0.5 / (n_dot_v * std::sqrt(n_dot_l * n_dot_l * (1 - a) + a) +
                  n_dot_l * std::sqrt(n_dot_v * n_dot_v * (1 - a) + a));
}

/// GGX times n·l with Schlick's Fresnel; z is along the normal.
inline double ggx(glm::dvec3 l, glm::dvec3 v, double alpha, double f0) {
    if (l.z <= 0) return 0;
    const glm::dvec3 h = glm::normalize(l + v);
    return l.z * ggx_density(h.z, alpha) * ggx_visibility(l.z, v.z, alpha) *
           (f0 + (1 - f0) * std::pow(1 - glm::dot(v, h), 5));
}

/// What a surface reflects under radiance 1 from everywhere: an integral over directions to the light in the angles about
/// the mirrored direction, fine where the lobe is narrow.
inline double white_reflection(double n_dot_v, double alpha, double f0) {
    constexpr double around = 6.28318530717958647693;
    const glm::dvec3 v(std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v), mirrored(-v.x, 0, v.z), side(0, 1, 0);
    const glm::dvec3 up = glm::cross(mirrored, side);
    double sum = 0;
    const int steps = 1200, turns = 400;
    for (int i = 0; i < steps; ++i) {
        // Angles that grow evenly in a power: dense within the lobe and out to the whole sphere.
        const double s = (i + 0.5) / steps, from = std::pow(s, 3) * 0.5 * around;
        const double width = 3 * s * s * 0.5 * around / steps;
        for (int j = 0; j < turns; ++j) {
            const double turn = around * (j + 0.5) / turns;
            const glm::dvec3 l =
                std::cos(from) * mirrored + std::sin(from) * (std::cos(turn) * side + std::sin(turn) * up);
            sum += std::sin(from) * width * (around / turns) * ggx(l, v, alpha, f0);
        }
    }
    return sum;
}

}  // namespace lightwalk::truth
