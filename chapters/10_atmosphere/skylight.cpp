#include "10_atmosphere/skylight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lightwalk {
namespace {

constexpr double pi = std::numbers::pi;

// exp(-h / scale) from a height out of the air along a slope, as 10.optical_depth has it.
double upwards(double height, double slope, double radius, double scale) {
    if (scale <= 0) return 0;
    const double ratio = (radius + height) / scale, x = std::sqrt(0.5 * ratio) * slope;
    const double s =
        x <= 8 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + x * (1.7245609 + x)) : 0.56498823 / (0.06651874 + x);
    return scale * std::exp(-height / scale) * std::sqrt(0.5 * pi * ratio) * s;
}

double depth(double height, double slope, double radius, double scale) {
    if (slope >= 0) return upwards(height, slope, radius, scale);
    const double lowest = (radius + height) * std::sqrt(1 - slope * slope) - radius;
    return 2 * upwards(std::max(lowest, 0.0), 0, radius, scale) - upwards(height, -slope, radius, scale);
}

double thinning(double height, double scale) { return scale > 0 ? std::exp(-height / scale) : 0; }

glm::dvec3 sky_light(const Air& air, double slope, double sun, double cos_angle) {
    const double r = double(air.radius), b = r * slope, top = r + double(air.top);
    const double way = -b + std::sqrt(b * b + top * top - r * r), g = double(air.mie_g);
    const glm::dvec3 rayleigh(air.rayleigh), dust(air.mie), taken(air.mie_extinction);
    const glm::dvec3 molecules = rayleigh * (3 / (16 * pi) * (1 + cos_angle * cos_angle));
    const glm::dvec3 grains = dust * ((1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cos_angle, 1.5)));
    glm::dvec3 behind(0), light(0);
    for (int i = 0; i < 16; ++i) {
        const double from = i * i / 256.0, to = (i + 1) * (i + 1) / 256.0, t = 0.5 * (from + to) * way;
        const double height = std::sqrt(r * r + 2 * r * slope * t + t * t) - r, part = (to - from) * way;
        const double cosine = (r * sun + t * cos_angle) / (r + height);
        const double h = thinning(height, double(air.rayleigh_height)), m = thinning(height, double(air.mie_height));
        const glm::dvec3 here = part * (rayleigh * h + taken * m);
        if (cosine > -std::sqrt(height * (2 * r + height)) / (r + height)) {
            const glm::dvec3 sunlight = glm::exp(-rayleigh * depth(height, cosine, r, double(air.rayleigh_height)) -
                                                 taken * depth(height, cosine, r, double(air.mie_height)));
            light += part * (molecules * h + grains * m) * sunlight * glm::exp(-behind - 0.5 * here);
        }
        behind += here;
    }
    return light;
}

// Of a sun of 1.
std::vector<glm::dvec3> unit_table(const Air& air) {
    constexpr int entries = 33, rings = 8, sectors = 6;
    std::vector<glm::dvec3> table;
    for (int i = 0; i < entries; ++i) {
        const double x = 2.0 * i / (entries - 1) - 1, sun = x * std::fabs(x), sun_sine = std::sqrt(1 - sun * sun);
        glm::dvec3 sum(0);
        for (int ring = 0; ring < rings; ++ring)
            for (int sector = 0; sector < sectors; ++sector) {
                // Rings evenly spaced in the squared cosine: each counts the same on level ground.
                const double slope = std::sqrt((ring + 0.5) / rings), around = pi * (sector + 0.5) / sectors;
                const double angle = slope * sun + std::sqrt(1 - slope * slope) * sun_sine * std::cos(around);
                sum += sky_light(air, slope, sun, angle);
            }
        table.emplace_back(sum * (pi / (rings * sectors)));
    }
    return table;
}

}  // namespace

bool SkylightTable::follow(const Air& air) {
    Air seen = air;
    seen.sun = glm::vec3(1.0f);
    seen.sun_rad = 0.0f;
    if (!made_.is_current(seen)) {
        of_unit_sun_ = unit_table(seen);
        scaled_.forget();
        ++made;
    }
    if (scaled_.is_current(air.sun)) return false;
    entries_.clear();
    for (const glm::dvec3& entry : of_unit_sun_) entries_.emplace_back(entry * glm::dvec3(air.sun));
    return true;
}

glm::vec3 skylight_of(const std::vector<glm::vec3>& table, float sun) {
    const float last = static_cast<float>(table.size() - 1);
    const float at = std::clamp(0.5f + 0.5f * std::copysign(std::sqrt(std::abs(sun)), sun), 0.0f, 1.0f) * last;
    const float first = std::min(std::floor(at), last - 1.0f);
    const auto i = static_cast<size_t>(first);
    return glm::mix(table[i], table[i + 1], at - first);
}

glm::vec3 sunlight_of(const Air& air, float sun) {
    if (sun <= 0.0f) return glm::vec3(0.0f);
    constexpr int samples = 512;
    const double r = double(air.radius), slope = double(sun), b = r * slope, top = r + double(air.top);
    const double way = -b + std::sqrt(b * b + top * top - r * r);
    glm::dvec3 depth(0);
    for (int i = 0; i < samples; ++i) {  // the nearer the ground, the denser
        const double from = double(i) * i / (samples * samples), to = (i + 1.0) * (i + 1.0) / (samples * samples);
        const double t = 0.5 * (from + to) * way, height = std::sqrt(r * r + 2 * r * slope * t + t * t) - r;
        const double layer =
            air.layer_width > 0
                ? std::max(0.0, 1 - std::fabs(height - double(air.layer_center)) / double(air.layer_width))
                : 0.0;
        depth +=
            (to - from) * way *
            (glm::dvec3(air.rayleigh) * thinning(height, double(air.rayleigh_height)) +
             glm::dvec3(air.mie_extinction) * thinning(height, double(air.mie_height)) + glm::dvec3(air.layer) * layer);
    }
    return glm::dvec3(air.sun) * glm::exp(-depth);
}

}  // namespace lightwalk
