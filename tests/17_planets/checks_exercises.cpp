// Checks of chapter 17's functions in GLSL: values against double precision, then properties.
#include <fmt/core.h>

#include "17_planets/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

/// Light of dust, as a sum over depths. mu0 is above 0, mu 0 or more.
double dust_by_depths(double mu0, double mu) {
    // In the path's own measure, t / mu, which has no end where mu is 0: the first grains are all that is seen there.
    const double rate = 1 + mu / mu0, end = 40 / rate;
    const int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (const double at : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
            const double path = (i + at) * end / steps;
            sum += 0.5 * end / steps * std::exp(-path * mu / mu0) * std::exp(-path);
        }
    return sum;
}

}  // namespace

CHECK_EXERCISE(
    "17.lommel_seeliger",
    "the integral of exp(-t / mu0) exp(-t / mu) dt / mu over t from 0 on: one exponential, of t (1 / mu0 + 1 / mu)") {
    const double overhead = dust_by_depths(1, 1);
    const auto dust = [=](double mu0, double mu) {
        return mu0 > 0 ? dust_by_depths(mu0, std::max(mu, 0.0)) / overhead : 0;
    };
    Probe probe{.include = "17_planets/lommel_seeliger.glsl",
                .signature = "float lommel_seeliger(float mu0, float mu)",
                .truth = [=](auto in) { return Row{dust(in[0], in[1])}; },
                .bound = {.absolute = 1e-4},
                .hint = [=](auto in, auto out) -> std::string {
                    const double mu0 = in[0], mu = in[1], right = dust(mu0, mu);
                    const auto is = [&](double other) { return std::fabs(out[0] - other) < 1e-4; };
                    if (mu0 <= 0) return "the sun is not up: no light gets in";
                    if (is(0.5 * right)) return "overhead, mu0 = mu = 1, it must be 1: divide by the sum's value there";
                    if (mu <= 0) return "at mu = 0 the camera sees the first grains alone, and the sum has the limit 2";
                    if (is(mu0)) return "that is Lambert's law, of light that is scattered often";
                    if (is(right * mu)) return "the camera's ray is dt / mu long, and not dt, between two depths";
                    if (is(right * mu / mu0))
                        return "sun and camera are exchanged: the ray that is dt / mu long is the camera's";
                    if (is(mu0 / mu) || is(1)) return "light is weakened twice: on its way in, and on its way out";
                    return "";
                }};
    for (const double mu0 : {1.0, 0.5, 1e-3, 1e-30, 0.0, -1e-3, -1.0})
        for (const double mu : {1.0, 0.25, 1e-3, 1e-30, 0.0, -1e-3, -1.0}) probe.inputs.push_back({mu0, mu});
    Random random(1);
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({i % 3 ? random.uniform(0, 1) : random.uniform(-1, 1),
                                i % 5 ? random.uniform(0, 1) : random.uniform(-1, 1)});
    check.probe(probe);
}

CHECK_EXERCISE("17.night_lights", "city times a smooth step of -n·l / 0.12 times what the clouds let through") {
    Probe probe{.include = "17_planets/night_lights.glsl",
                .signature = "vec3 night_lights(vec3 city, float cosine, float cloud)",
                .inputs = {{1, 2, 3, 0.5, 0},
                           {1, 2, 3, 0, 0},
                           {1, 2, 3, -0.06, 0},
                           {1, 2, 3, -0.12, 0},
                           {1, 2, 3, -1, 0},
                           {1, 2, 3, -1, 1},
                           {1, 2, 3, -1, 0.25}},
                .truth =
                    [](auto in) {
                        const double share = truth::night_lights(in[3], in[4]);
                        return Row{share * in[0], share * in[1], share * in[2]};
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-4},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[3] >= 0 && out[0] != 0) return "by day the lamps are off: not 1 - n·l, -n·l";
                    if (in[4] == 1 && out[0] != 0) return "an opaque cloud hides them";
                    return "";
                }};
    Random random(2);
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4),
                                i % 2 ? random.uniform(-0.14, 0.02) : random.uniform(-1, 1), random.uniform(0, 1)});
    check.probe(probe);
}

CHECK_EXERCISE("17.ring_phase", "two sides first: lit where sun_side and eye_side have one sign; then (1 + cos) / 2") {
    Probe probe{
        .include = "17_planets/ring_phase.glsl",
        .signature =
            "vec3 ring_phase(vec3 back, vec3 forward, vec3 unlit, float cos_phase, float sun_side, float eye_side)",
        .truth =
            [](auto in) {
                const bool lit = in[10] * in[11] > 0;
                const double share = 0.5 + 0.5 * in[9];
                const glm::dvec3 light = lit ? glm::mix(vector3(in, 3), vector3(in), share) : vector3(in, 6);
                return Row{light.x, light.y, light.z};
            },
        .bound = {.absolute = 1e-5, .relative = 1e-5},
        .hint = [](auto in, auto out) -> std::string {
            const bool lit = in[10] * in[11] > 0;
            if (!lit) return "from that side one sees what comes through: unlit";
            if (std::fabs(out[0] - (in[3] + in[9] * (in[0] - in[3]))) < 1e-5)
                return "cos_phase is the share there, which extrapolates below 0: (1 + cos_phase) / 2";
            if (std::fabs(out[0] - (in[0] + (0.5 + 0.5 * in[9]) * (in[3] - in[0]))) < 1e-5)
                return "1 is back, the sun behind the camera";
            return "";
        }};
    // The sun behind the camera, beside and before it, from either side; then the ring's edge.
    for (const double cos_phase : {1.0, 0.0, -1.0})
        for (const double side : {0.5, -0.5})
            for (const double eye : {0.5, -0.5, 0.0})
                probe.inputs.push_back({1, 2, 3, 4, 5, 6, 0.25, 0.5, 0.75, cos_phase, side, eye});
    for (const double eye : {0.5, -0.5, 0.0}) probe.inputs.push_back({1, 2, 3, 4, 5, 6, 0.25, 0.5, 0.75, 0.5, 0, eye});
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        Row row;
        for (int c = 0; c < 9; ++c) row.push_back(random.uniform(0, 2));
        for (int c = 0; c < 3; ++c) row.push_back(random.uniform(-1, 1));
        probe.inputs.push_back(row);
    }
    // Nearly from the edge: a product of two small numbers is 0 long before either is.
    probe.inputs.push_back({1, 1, 1, 2, 2, 2, 3, 3, 3, 0, 1e-25, 1e-25});
    check.probe(probe);
}

CHECK_EXERCISE("17.limb_fade", "a longer way through the layer, 1 / mu; then the smooth step of mu / width") {
    Probe probe{.include = "17_planets/limb_fade.glsl",
                .signature = "float limb_fade(float opacity, float mu, float width)",
                .inputs = {{0.5, 1, 0.1},
                           {0.5, 0.5, 0.1},
                           {1, 0.5, 0.1},
                           {1, 0.05, 0.1},
                           {0, 0.5, 0.1},
                           {0.5, 0, 0.1},
                           {1, 0, 0.1},
                           {0.5, -0.5, 0.1},
                           {0, 0, 1}},
                .truth = [](auto in) { return Row{truth::limb_fade(in[0], in[1], in[2])}; },
                .bound = {.absolute = 1e-4, .relative = 1e-4},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[1] <= 0 && out[0] != 0) return "from below, through the planet, nothing of it is seen";
                    if (std::fabs(out[0] - in[0] * truth::smooth(in[1] / in[2])) < 1e-4 && in[1] < 0.9)
                        return "seen at an angle the way through the layer is longer, 1 / mu";
                    if (in[1] < in[2] && out[0] > truth::limb_fade(in[0], in[1], in[2]))
                        return "it fades where mu is below the width";
                    return "";
                }};
    Random random(4);
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back(
            {random.uniform(0, 1), i % 2 ? random.uniform(0, 0.2) : random.uniform(-1, 1), random.uniform(0.02, 1)});
    check.probe(probe);
}

CHECK_EXERCISE("17.flow_blend",
               "A is read against the wind for t of the interval, B with it for the 1 - t that is left") {
    Probe places{.include = "17_planets/flow_blend.glsl",
                 .signature = "vec4 flow_places(vec2 uv, vec2 shift, float t)",
                 .inputs = {{0.5, 0.5, 0.1, 0, 0}, {0.5, 0.5, 0.1, 0, 1}, {0.5, 0.5, 0.1, -0.2, 0.5}},
                 .truth =
                     [](auto in) {
                         const glm::dvec2 uv(in[0], in[1]), shift(in[2], in[3]);
                         const glm::dvec2 a = uv - shift * in[4], b = uv + shift * (1 - in[4]);
                         return Row{a.x, a.y, b.x, b.y};
                     },
                 .bound = {.absolute = 1e-6},
                 .hint = [](auto in, auto out) -> std::string {
                     if (in[4] > 0 && std::fabs(out[0] - in[0] - in[2] * in[4]) < 1e-6 && in[2] != 0)
                         return "what is here now was up the wind: uv - shift t";
                     if (in[4] < 1 && std::fabs(out[2] - in[0] + in[2] * in[4]) < 1e-6 && in[2] != 0)
                         return "B was taken later: what is here now is down the wind in it";
                     return "";
                 }};
    Random random(5);
    for (int i = 0; i < 200; ++i)
        places.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(-0.3, 0.3),
                                 random.uniform(-0.3, 0.3), random.uniform(0, 1)});
    check.probe(places);
    Probe weight{.include = "17_planets/flow_blend.glsl",
                 .signature = "float flow_weight(float t)",
                 .inputs = {{0}, {0.25}, {0.5}, {0.75}, {1}},
                 .truth = [](auto in) { return Row{in[0]}; },
                 .bound = {.absolute = 1e-6},
                 .hint = [](auto in, auto) -> std::string {
                     return in[0] == 0 ? "at the beginning A alone is seen" : "evenly from 0 to 1";
                 }};
    check.probe(weight);
}

CHECK_EXERCISE("17.ellipsoid_shadow", "stretch the point and the direction along the pole, then ask chapter 05") {
    Probe probe{
        .include = "17_planets/ellipsoid_shadow.glsl",
        .signature =
            "float ellipsoid_shadow(vec3 point, vec3 pole, float radius, float flattening, vec3 to_sun, float sun_rad)",
        .truth =
            [](auto in) {
                return Row{truth::ellipsoid_shadow(vector3(in), vector3(in, 3), in[6], in[7], vector3(in, 8), in[11])};
            },
        .bound = {.absolute = 0.07},
        .hint = [](auto in, auto out) -> std::string {
            const double round = truth::ellipsoid_shadow(vector3(in), vector3(in, 3), in[6], 0, vector3(in, 8), in[11]);
            if (std::fabs(out[0] - round) < 0.03) return "that is the shadow of a sphere";
            return "along the pole by 1 / (1 - flattening): the point, and the direction, which is normalised again";
        }};
    Random random(6);
    for (int i = 0; i < 500; ++i) {
        const bool saturn = i % 2;
        const glm::dvec3 pole(saturn ? glm::vec3(0, 1, 0) : random.direction()), to_sun(random.direction());
        const double radius = i % 3 ? 60268e3 : 1, f = saturn ? 0.098 : random.uniform(0, 0.15);
        const double sun_rad = i % 5 ? random.uniform(0.01, 0.08) : 0.00049;
        // Behind the planet, near the edge of its shadow.
        const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(random.direction()), to_sun));
        glm::dvec3 point = radius * (random.uniform(0.8, 1.1) * side - random.uniform(1.3, 3) * to_sun);
        if (i % 11 == 0) point = -point;
        Row row;
        append(row, glm::vec3(point));
        append(row, glm::vec3(pole));
        row.push_back(radius);
        row.push_back(f);
        append(row, glm::vec3(to_sun));
        row.push_back(sun_rad);
        const double seen = truth::ellipsoid_shadow(point, pole, radius, f, to_sun, sun_rad, 24);
        if (i % 5 == 0 && seen > 0 && seen < 1) continue;  // a sun so small is a matter of one pixel
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
