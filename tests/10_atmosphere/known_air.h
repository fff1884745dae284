// An air that shaders of checks and tests know without a buffer, and the same as numbers.
#pragma once
#include <fmt/core.h>

#include <cmath>

#include "10_atmosphere/air_data.h"
#include "common/gpu/macros.h"

namespace lightwalk {

constexpr double earth = 6360000, edge = 100000;  // metres: its radius, and where its air ends above the ground

inline Air earth_air() {
    return {.rayleigh = 1e-6f * glm::vec3(5.802f, 13.558f, 33.1f),
            .rayleigh_height = 8000,
            .mie = glm::vec3(3.996e-6f),
            .mie_height = 1200,
            .mie_extinction = glm::vec3(4.44e-6f),
            .mie_g = 0.75f,
            .layer = 1e-6f * glm::vec3(0.65f, 1.881f, 0.085f),
            .layer_center = 25000,
            .layer_width = 15000,
            .radius = 6360000,
            .top = 100000,
            .sun = glm::vec3(10.0f),
            .sun_rad = 0.004625f,
            .ground = glm::vec3(0.1f)};
}

/// GLSL inserted before 10_atmosphere/air.glsl.
inline const char* const with_known_air = "#include \"../tests/10_atmosphere/known_air.glsl\"\n";

/// The air for it; with the phase function that Atmosphere's knob says by default.
inline Macros known_air(const Air& air) {
    const auto vec = [](glm::vec3 v) { return fmt::format("vec3({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z); };
    return {{"CHECK_KNOWN_AIR",
             fmt::format("Air({}, float({:.9g}), {}, float({:.9g}), {}, float({:.9g}), {}, float({:.9g}), "
                         "float({:.9g}), float({:.9g}), float({:.9g}), {}, float({:.9g}), {})",
                         vec(air.rayleigh), air.rayleigh_height, vec(air.mie), air.mie_height, vec(air.mie_extinction),
                         air.mie_g, vec(air.layer), air.layer_center, air.layer_width, air.radius, air.top,
                         vec(air.sun), air.sun_rad, vec(air.ground))},
            {"ATMOSPHERE_PHASE", "2"},
            {"ATMOSPHERE_PHASE_ISOTROPIC", "0"},
            {"ATMOSPHERE_PHASE_HENYEY_GREENSTEIN", "1"},
            {"ATMOSPHERE_PHASE_CORNETTE_SHANKS", "2"}};
}

// The least slope that clears the ground, and a little more.
inline double above_horizon(double height, double share, double radius = earth) {
    const double horizon = -std::sqrt(height * (2 * radius + height)) / (radius + height);
    return double(float(horizon + (1 - horizon) * share + 1e-6));
}

}  // namespace lightwalk
