// Checks of chapter 10: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "10_atmosphere/truth.h"
#include "common/check/check.h"
#include "known_air.h"

using namespace lightwalk;

CHECK_EXERCISE("10.ray_sphere", "c = (height - shell)(2 radius + height + shell); one root is q, the other c / q.") {
    Probe probe{.include = "10_atmosphere/ray_sphere.glsl",
                .signature = "vec2 ray_sphere(float height, float slope, float radius, float shell)",
                .inputs = {{0, 0, earth, 0},           {0, -0.25, earth, 0},      {0, 0.25, earth, 0},
                           {0, 1e-4, earth, edge},     {2, -1, earth, 0},         {2, 1, earth, 0},
                           {2, -0.5, earth, edge},     {edge, 0.5, earth, edge},  {edge, -0.5, earth, edge},
                           {4e5, 0.5, earth, edge},    {4e5, -1, earth, edge},    {4e5, 0, earth, edge},
                           {1e7, -0.2, earth, edge},   {1e7, -0.99, earth, edge}, {50, -0.125, 3389500, 0},
                           {-1000, 0.5, earth, edge},  // below the ground, where rounding leads
                           {-1000, -0.5, earth, 0},    {-1000, 0.5, earth, 0},    {-6e5, 0.25, earth, edge},
                           {6e7, -0.999, earth, edge}, {0.5, -0.75, 2, 0.25}},
                .truth =
                    [](std::span<const double> in) {
                        const glm::dvec2 t = truth::ray_sphere(in[0], in[1], in[2], in[3]);
                        return Row{t.x, t.y};
                    },
                .bound = {.absolute = 0.02, .relative = 2e-5},
                .hint = [](auto in, auto out) -> std::string {
                    if (out[0] == 1 && out[1] == -1 && in[0] < in[3]) return "From inside a sphere every ray meets it.";
                    if (in[0] < 10) return "The smaller of the two roots is a difference of nearly equal numbers.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 400; ++i) {  // from 2 m the horizon lies 5 km away
        const double height = random.logarithmic(0.5, 9e4);
        probe.inputs.push_back({height, random.uniform(-1, -0.3), earth, 0});
        probe.inputs.push_back({height, random.uniform(-1, 1), earth, edge});
    }
    for (int i = 0; i < 200; ++i)
        probe.inputs.push_back({random.logarithmic(2e5, 5e7), random.uniform(-1, -0.99), earth, edge});
    // Grazing rays may hit or miss by rounding: test only clear cases.
    std::erase_if(probe.inputs, [](const Row& in) {
        const double b = (in[2] + in[0]) * in[1], c = (in[0] - in[3]) * (2 * in[2] + in[0] + in[3]), d = b * b - c;
        return d != 0 && std::fabs(d) < 1e-3 * b * b;
    });
    const Table results = check.probe(probe);
    check.property(probe, results, "but the nearer one comes first, and (1, -1) where there is none",
                   [](auto, auto out) { return out[0] <= out[1] || (out[0] == 1 && out[1] == -1); });
}

CHECK_EXERCISE("10.density",
               "exp(-height / scale) needs a scale above 0; the layer is max(1 - |distance| / width, 0).") {
    Probe probe{.include = "10_atmosphere/density.glsl",
                .signature =
                    "vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, "
                    "float layer_width)",
                .inputs = {{0, 8000, 1200, 25000, 15000},
                           {8000, 8000, 1200, 25000, 15000},
                           {25000, 8000, 1200, 25000, 15000},
                           {10000, 8000, 1200, 25000, 15000},
                           {40000, 8000, 1200, 25000, 15000},
                           {99000, 8000, 1200, 25000, 15000},
                           {-0.5, 8000, 1200, 25000, 15000},
                           {-600, 8000, 1200, 25000, 15000},
                           {0, 0, 1200, 25000, 15000},
                           {500, 8000, 0, 25000, 15000},
                           {0, 8000, 0, 25000, 15000},
                           {-600, 8000, 1200, 0, 5000},
                           {0, 0, 0, 0, 0},
                           {25000, 8000, 1200, 25000, 0},
                           {0, 8000, 1200, 0, 5000}},
                .truth =
                    [](std::span<const double> in) {
                        Row row;
                        append(row, truth::density(in[0], in[1], in[2], in[3], in[4]));
                        return row;
                    },
                .bound = {.absolute = 1e-6, .relative = 2e-5},
                .hint = [](auto in, auto) -> std::string {
                    if (in[1] == 0 || in[2] == 0 || in[4] == 0)
                        return "A scale height of 0 must not be divided by: there are no such particles.";
                    return in[0] < 0 ? "Below the ground use the density at the ground." : "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back({random.uniform(0, 1e5), random.uniform(500, 2e4), random.uniform(500, 5e3),
                                random.uniform(0, 4e4), random.uniform(1e3, 3e4)});
    check.probe(probe);
}

CHECK_EXERCISE("10.phase_rayleigh", "The factor 3 / (16 pi) makes the integral over the sphere 1.") {
    Probe probe{.include = "10_atmosphere/phase_rayleigh.glsl",
                .signature = "float phase_rayleigh(float cos_angle)",
                .truth = [](std::span<const double> in) { return Row{truth::phase_rayleigh(in[0])}; },
                .bound = {.relative = 2e-6}};
    for (int i = -50; i <= 50; ++i) probe.inputs.push_back({double(float(i) / 50)});
    const Table results = check.probe(probe);
    double sum = 0;
    for (const Row& row : results) sum += 2 * truth::pi * row[0] * 0.02;
    check.expect(std::fabs(sum - 1) < 0.03,
                 fmt::format("over all directions it adds up to {:.3f}, expected 1: light is {}", sum,
                             sum < 1 ? "lost" : "made"));
}

CHECK_EXERCISE("10.phase_mie", "x^1.5 is x sqrt(x); and divide by 4 pi.") {
    Probe probe{
        .include = "10_atmosphere/phase_mie.glsl",
        .signature = "float phase_mie(float cos_angle, float g)",
        .inputs = {{1, 0.99}, {-1, 0.99}, {1, -0.99}, {-1, -0.99}, {1, 0}, {0, 0}, {-1, 0}, {1, 0.9}, {0.5, 0.76}},
        .truth = [](std::span<const double> in) { return Row{truth::phase_cornette_shanks(in[0], in[1])}; },
        // The bracket as published errs by up to 0.17% where it is small, a sum of positive terms by 1e-6, pow() by 0.03%.
        .bound = {.relative = 5e-4}};
    for (const float g : {0.9891f, 0.9888f})
        for (const float away : {2.74e-6f, 2.56e-6f, 2.44e-6f})
            for (const int sign : {1, -1}) probe.inputs.push_back({sign * double(1 - away), sign * double(g)});
    Random random;
    for (int i = 0; i < 600; ++i) probe.inputs.push_back({random.uniform(-1, 1), random.uniform(-0.95, 0.95)});
    const Table results = check.probe(probe);
    check.property(probe, results, "but a share of light is above 0", [](auto, auto out) { return out[0] > 0; });
}

CHECK_EXERCISE("10.in_scatter", "The light of a part passes through the parts before it and half of its own.") {
    const Air air = earth_air();
    const auto phase = [&](double c) { return truth::phase_cornette_shanks(c, double(air.mie_g)); };
    Probe probe{.include = "../tests/10_atmosphere/in_scatter_known.glsl",
                .before = with_known_air,
                .signature = "Along in_scatter(int samples, Path path)",
                .truth =
                    [&](std::span<const double> in) {
                        const Path path{float(in[1]), float(in[2]), float(in[3]), float(in[4]), float(in[5])};
                        glm::dvec3 through;
                        const glm::dvec3 light = truth::in_scatter(air, path, phase, int(in[0]), 24, &through);
                        Row row;
                        append(row, light);
                        append(row, through);
                        return row;
                    },
                .bound = {.absolute = 1e-5, .relative = 2e-3},
                .macros = known_air(air),
                .words = {},
                .hint = [](auto in, auto out) -> std::string {
                    if (out[3] == 1 && out[5] == 1)
                        return "Air attenuates light: the transmittance is exp(-depth) of all parts together.";
                    if (in[0] == 1) return "With one part, its middle lies behind half of it.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 60; ++i) {
        const double height = random.uniform(10, 40000), slope = random.uniform(0.02, 1), sun = random.uniform(-0.2, 1);
        const double sine = std::sqrt((1 - slope * slope) * (1 - sun * sun));
        probe.inputs.push_back({double(i % 6 + 1), height, slope, sun,
                                double(float(slope * sun + sine * random.uniform(-1, 1))),
                                random.uniform(100, 300000)});
    }
    probe.inputs.push_back({16, 2, 1, 0.5, 0.5, 99000});
    probe.inputs.push_back({4, 2, 0.5, -0.9, 0.2, 90000});  // night
    const Table results = check.probe(probe);
    check.property(probe, results, "but no more than all gets through, and no light is below 0",
                   [](auto, auto out) { return out[3] <= 1 && out[4] <= 1 && out[5] <= 1 && out[0] >= 0; });
    // By night, with light from all sides that was scattered before.
    probe.include = "../tests/10_atmosphere/in_scatter_glowing.glsl";
    probe.truth = [&](std::span<const double> in) {
        const double radius = double(air.radius), r0 = radius + in[1], part = in[5] / in[0];
        glm::dvec3 depth(0), light(0);
        for (int i = 0; i < int(in[0]); ++i) {
            const double t = (i + 0.5) * part, height = std::sqrt(r0 * r0 + 2 * r0 * in[2] * t + t * t) - radius;
            const glm::dvec3 d = truth::density(height, double(air.rayleigh_height), double(air.mie_height),
                                                double(air.layer_center), double(air.layer_width));
            const glm::dvec3 scattered = glm::dvec3(air.rayleigh) * d.x + glm::dvec3(air.mie) * d.y;
            const glm::dvec3 taken = part * (glm::dvec3(air.rayleigh) * d.x + glm::dvec3(air.mie_extinction) * d.y +
                                             glm::dvec3(air.layer) * d.z);
            light += part * scattered * (glm::dvec3(3, 2, 1) + 1e-4 * height) * glm::exp(-depth - 0.5 * taken);
            depth += taken;
        }
        Row row;
        append(row, light);
        append(row, glm::exp(-depth));
        return row;
    };
    probe.hint = [](auto, auto) { return "scattered_before arrives from all sides: no phase function belongs to it."; };
    check.probe(probe);
}

CHECK_EXERCISE("10.place_at",
               "Add up two vectors, from the planet's centre: how far is each of them towards the sun?") {
    const Air air = earth_air();
    Probe probe{.include = "../tests/10_atmosphere/place_at_known.glsl",
                .before = with_known_air,
                .signature = "Place place_at(float t, Path path)",
                .inputs = {{1e6, 0, 0.5, 0.25, 0.875, 0},
                           {1e6, 0, 0, 0, 1, 0},
                           {1e6, 0, 0, 0, -1, 0},
                           {1e6, 0, 0, 0, 0, 0},
                           {1e5, 0, 1, 0.5, 0.5, 0},
                           {2e6, 4e5, 0, -0.3, 0.9, 0},
                           {1e5, 0, 1, 1, 1, 0}},
                .truth =
                    [radius = double(air.radius)](std::span<const double> in) {
                        // Up is y; the path lies in the plane z = 0; the sun where both angles are right.
                        const glm::dvec3 start(0, radius + in[1], 0);
                        const glm::dvec3 along(std::sqrt(std::max(1 - in[2] * in[2], 0.0)), in[2], 0);
                        const double x = along.x > 1e-9 ? (in[4] - in[2] * in[3]) / along.x : 0;
                        const glm::dvec3 to_sun(x, in[3], std::sqrt(std::max(1 - x * x - in[3] * in[3], 0.0)));
                        const glm::dvec3 end = start + in[0] * along;
                        return Row{glm::length(end) - radius, glm::dot(glm::normalize(end), glm::normalize(to_sun))};
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-5},
                .macros = known_air(air),
                .hint = [radius = double(air.radius)](auto in, auto got) -> std::string {
                    if (std::abs(got[1] - in[3]) < 1e-6)
                        return "Straight up turns along the way: the sun is not as high as at the start.";
                    const double by_slope = ((radius + in[1]) * in[3] + in[0] * in[2]) / (radius + got[0]);
                    if (std::abs(got[1] - by_slope) < 1e-5)
                        return "How far does a step along the path lead towards the sun, and not upwards?";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 along(random.direction()), to_sun(random.direction());
        const double height = random.logarithmic(1, 1e6), way = random.logarithmic(100, 5e6);
        if (glm::length(glm::dvec3(0, earth + height, 0) + way * along) < earth) continue;
        // As floats, and a sun that can be where they say.
        const double slope = double(float(along.y)), sun = double(float(to_sun.y));
        probe.inputs.push_back({way, height, slope, sun, double(float(glm::dot(along, to_sun))), 0});
    }
    check.probe(probe);
}

CHECK_EXERCISE("10.height_fog", "Use the density at the lower end, and x of 0 or more; use a series for a small x.") {
    Probe probe{
        .include = "10_atmosphere/height_fog.glsl",
        .signature = "float height_fog(float density, float falloff, float y, float slope, float distance)",
        .inputs = {{1e-3, 0, 5, 0.5, 1000},
                   {1e-3, 0.01, 5, 0, 1000},
                   {1e-3, 1e-3, 0, 1e-3, 1000},
                   {1e-3, 1e-3, 0, 1e-6, 1000},
                   {1e-3, 1e-3, 0, 2e-8, 1000},
                   {1e-3, 1e-3, 0, -1e-6, 1000},
                   {1e-3, 0.1, 0, 0.01, 1},
                   {1e-3, 0.01, 20000, -1, 20000},
                   {1e-3, 0.1, 1000, -1, 1000},
                   {1e-3, 0.1, 0, 1, 1e5},
                   {0, 0.1, 10, -0.1, 50},
                   {1e-3, 0.1, 10, -0.1, 0},
                   {0.01, 0.02, -100, 0.1, 900}},
        .truth = [](std::span<const double> in) { return Row{truth::fog_depth(in[0], in[1], in[2], in[3], in[4])}; },
        .bound = {.absolute = 1e-12, .relative = 3e-5},
        .hint = [](auto in, auto out) -> std::string {
            const double x = std::fabs(in[1] * in[3] * in[4]);
            if (!std::isfinite(out[0])) return x == 0 ? "0 / 0" : "exp() of a large number";
            return x < 0.01 ? "1 - exp(-x) has lost its digits" : "";
        }};
    Random random;
    for (int i = 0; i < 600; ++i) {
        const double falloff = random.logarithmic(1e-5, 0.1), y = random.uniform(-50, 200) * (i % 3 + 1);
        probe.inputs.push_back({random.logarithmic(1e-6, 0.1), falloff, y,
                                i % 2 ? random.uniform(-1, 1) : random.logarithmic(1e-9, 1e-2),
                                random.logarithmic(0.1, 3e3)});
    }
    std::erase_if(probe.inputs, [](const Row& in) { return -in[1] * std::min(in[2], in[2] + in[3] * in[4]) > 70; });
    const Table results = check.probe(probe);
    check.property(probe, results, "but fog is never less than none", [](auto, auto out) { return out[0] >= 0; });
}

CHECK_EXERCISE("10.table_uv", "0 belongs on the centre of the first texel: (0.5 + x (size - 1)) / size.") {
    const std::string file = "10_atmosphere/table_uv.glsl";
    // In double: where the way out is kept.
    const auto uv = [](std::span<const double> in) {
        const double height = in[0], slope = in[1], radius = in[2], top = in[3];
        const auto level = [&](double h) { return std::sqrt(h * (2 * radius + h)); };
        const double way = truth::ray_sphere(height, slope, radius, top).y;
        const double most = level(height) + level(top), least = top - height;
        const double x = most > least ? std::clamp((way - least) / (most - least), 0.0, 1.0) : 0;
        return Row{(0.5 + x * (in[4] - 1)) / in[4], (0.5 + level(height) / level(top) * (in[5] - 1)) / in[5]};
    };
    Probe there{.include = file,
                .signature = "vec2 table_uv(float height, float slope, float radius, float top, vec2 size)",
                .inputs = {{0, 0, earth, edge, 256, 64},
                           {0, 1, earth, edge, 256, 64},
                           {edge, 1, earth, edge, 256, 64},
                           {2, 0, earth, edge, 256, 64},
                           {500, 0.5, earth, edge, 64, 16},
                           {40000, above_horizon(40000, 0), earth, edge, 256, 64}},
                .truth = uv,
                .bound = {.absolute = 1e-4},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[0] == 0 && out[1] < 0.4 / in[5])
                        return "Use the centre of the first texel, not the edge of the table.";
                    return "";
                }};
    Probe back{.include = file,
               .signature = "vec2 table_place(vec2 uv, float radius, float top, vec2 size)",
               .bound = {.absolute = 1}};
    Random random;
    for (int i = 0; i < 300; ++i) {
        const double height = random.logarithmic(1, 9e4);
        there.inputs.push_back({height, above_horizon(height, random.uniform(0, 1)), earth, edge, 256, 64});
    }
    check.probe(there);

    // The inverse, for every texel: back to where it came from.
    const double w = 32, h = 16;
    std::vector<glm::dvec2> places;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) back.inputs.push_back({(x + 0.5) / w, (y + 0.5) / h, earth, edge, w, h});
    back.truth = [&](std::span<const double> in) {
        const double level_top = std::sqrt(edge * (2 * earth + edge)), level = (in[1] * h - 0.5) / (h - 1) * level_top;
        const double height = std::sqrt(earth * earth + level * level) - earth, least = edge - height;
        const double way = least + (in[0] * w - 0.5) / (w - 1) * (level + level_top - least);
        if (way < 1e-3) return Row{height, 1};
        return Row{height, ((edge - height) * (2 * earth + edge + height) - way * way) / (2 * (earth + height) * way)};
    };
    const Table found = check.probe(back);
    check.property(back, found, "but a slope is -1 to 1, and a height 0 to top",
                   [](auto, auto out) { return std::fabs(out[1]) <= 1 && out[0] > -1 && out[0] < edge + 1; });
    double worst = 0;
    for (size_t i = 0; i < found.size(); ++i)
        worst = std::max(worst, std::fabs(found[i][1] - back.truth(back.inputs[i])[1]));
    check.expect(worst < 1e-4, fmt::format("table_place gives a slope that is off by {:.4g}", worst),
                 "way² + 2 (radius + height) way slope = (top - height)(2 radius + top + height)");
}
