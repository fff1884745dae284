// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "10_atmosphere/air_data.h"

namespace lightwalk::truth {

inline constexpr double pi = std::numbers::pi;

/// Where a ray meets a sphere `shell` above a planet's ground: in order, or (1, -1).
inline glm::dvec2 ray_sphere(double height, double slope, double radius, double shell) {
    const long double r = static_cast<long double>(radius) + height, s = static_cast<long double>(radius) + shell;
    const long double b = r * slope, d = b * b - (r - s) * (r + s);
    if (d < 0) return {1, -1};
    const long double q = -(b + (b < 0 ? -1 : 1) * std::sqrt(d));
    const long double other = q == 0 ? 0 : (r - s) * (r + s) / q;
    return {double(std::min(q, other)), double(std::max(q, other))};
}

inline double thinning(double height, double scale) { return scale > 0 ? std::exp(-height / scale) : 0; }

/// Of molecules, dust and the layer.
inline glm::dvec3 density(double height, double rayleigh, double mie, double center, double width) {
    height = std::max(height, 0.0);
    const double layer = width > 0 ? std::max(0.0, 1 - std::fabs(height - center) / width) : 0;
    return {thinning(height, rayleigh), thinning(height, mie), layer};
}

inline double phase_rayleigh(double c) { return 3 / (16 * pi) * (1 + c * c); }
inline double phase_henyey_greenstein(double c, double g) {
    return (1 - g * g) / (4 * pi) / std::pow(1 + g * g - 2 * g * c, 1.5);
}
inline double phase_cornette_shanks(double c, double g) {
    return 3 / (8 * pi) * (1 - g * g) / (2 + g * g) * (1 + c * c) / std::pow(1 + g * g - 2 * g * c, 1.5);
}

/// The integral of f over all directions by Simpson's rule; f takes the cosine with a fixed one.
template <class F>
double over_sphere(const F& f, int parts = 20000) {
    double sum = 0;
    for (int i = 0; i <= parts; ++i) sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * f(-1 + 2.0 * i / parts);
    return 2 * pi * sum * 2 / (3.0 * parts);
}

/// exp(-h / scale) along a ray out of the air, up to 60 scale heights, in metres: `steps` that grow with the distance.
inline double optical_depth(double height, double slope, double radius, double scale, int steps = 4000) {
    if (scale <= 0) return 0;
    const double r = radius + height, top = radius + height + 60 * scale;
    const double b = r * slope, way = -b + std::sqrt(std::max(b * b + top * top - r * r, 0.0));
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double from = double(i) * i / steps / steps, to = double(i + 1) * (i + 1) / steps / steps;
        const double t = 0.5 * (from + to) * way, k = 2 * r * slope * t + t * t;
        sum += (to - from) * way * std::exp(-(height + k / (r + std::sqrt(r * r + k))) / scale);
    }
    return sum;
}

/// Fog's density, which falls with height, integrated along a ray: Simpson's rule.
inline double fog_depth(double density, double falloff, double y, double slope, double distance) {
    const double climb = falloff * slope * distance;
    const double mean = climb == 0 ? 1 : -std::expm1(-climb) / climb;
    return density * std::exp(-falloff * y) * distance * mean;
}

/// Single scattering by brute force: `steps` points on the path, `light_steps` from each towards the sun. `phase` is
/// the dust's. The sun's disc sets behind the ground's edge as in the shaders.
template <class Phase>
glm::dvec3 in_scatter(const Air& air, const Path& path, const Phase& phase, int steps, int light_steps,
                      glm::dvec3* transmittance = nullptr) {
    const double radius = double(air.radius), r0 = radius + double(path.height), part = double(path.way) / steps;
    const auto extinction = [&](double height) {
        const glm::dvec3 d = density(height, double(air.rayleigh_height), double(air.mie_height),
                                     double(air.layer_center), double(air.layer_width));
        return glm::dvec3(air.rayleigh) * d.x + glm::dvec3(air.mie_extinction) * d.y + glm::dvec3(air.layer) * d.z;
    };
    const double c = double(path.cos_angle);
    const glm::dvec3 molecules = glm::dvec3(air.rayleigh) * phase_rayleigh(c), dust = glm::dvec3(air.mie) * phase(c);
    glm::dvec3 depth(0), light(0);
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) * part, r = std::sqrt(r0 * r0 + 2 * r0 * double(path.slope) * t + t * t);
        const double height = r - radius, sun = (r0 * double(path.sun) + t * c) / r;
        const double horizon = -std::sqrt(std::max(height * (2 * radius + height), 0.0)) / r;
        const double dip = std::max(std::sqrt(1 - horizon * horizon), 1e-3), rad = double(air.sun_rad);
        const double x = std::clamp(((sun - horizon) / dip + rad) / (2 * rad), 0.0, 1.0), share = x * x * (3 - 2 * x);
        const glm::dvec3 taken = part * extinction(height);
        if (share > 0) {
            const double s = std::max(sun, horizon), b = r * s, top = radius + double(air.top);
            const double way = -b + std::sqrt(std::max(b * b + top * top - r * r, 0.0));
            glm::dvec3 shade(0);
            for (int k = 0; k < light_steps; ++k) {
                const double from = double(k) * k / light_steps / light_steps;
                const double to = double(k + 1) * (k + 1) / light_steps / light_steps, u = 0.5 * (from + to) * way;
                shade += (to - from) * way * extinction(std::sqrt(r * r + 2 * b * u + u * u) - radius);
            }
            const double rayleigh = thinning(std::max(height, 0.0), double(air.rayleigh_height));
            const double mie = thinning(std::max(height, 0.0), double(air.mie_height));
            light += part * share * (molecules * rayleigh + dust * mie) * glm::exp(-shade - depth - 0.5 * taken);
        }
        depth += taken;
    }
    if (transmittance) *transmittance = glm::exp(-depth);
    return light * glm::dvec3(air.sun);
}

}  // namespace lightwalk::truth
