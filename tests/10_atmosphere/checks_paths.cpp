// Checks of the exercises about paths through air and fog: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "10_atmosphere/truth.h"
#include "common/check/check.h"
#include "known_air.h"

using namespace lightwalk;

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
    for (int i = 0; i < 200; ++i)  // straight up, to the sun or away from it, where rounding leads beyond 1 and -1
        probe.inputs.push_back(
            {random.logarithmic(100, 5e6), random.logarithmic(1, 1e6), 1, i % 2 ? 1.0 : -1.0, i % 2 ? 1.0 : -1.0, 0});
    const Table results = check.probe(probe);
    check.property(probe, results, "but a cosine is from -1 to 1",
                   [](auto, auto got) { return got[1] >= -1 && got[1] <= 1; });
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
