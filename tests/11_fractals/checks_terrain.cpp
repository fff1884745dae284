// Checks of chapter 11's terrain: values against double precision, then properties.
#include <fmt/core.h>

#include "11_fractals/noise.h"
#include "11_fractals/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

glm::ivec2 cell_of(std::span<const double> in) { return {int(in[0]), int(in[1])}; }

// Cells near and far, below 0 and at the ends of the integer range; points in them, corners and edges among them.
Table places(int count) {
    Table rows;
    Random random(11);
    for (const double x : {0.0, 1.0, -1.0, -7.0, 4000000.0, -2147483648.0, 2147483646.0})
        for (const glm::dvec2 f : {glm::dvec2{0, 0}, {1, 1}, {0.5, 0}, {0, 0.25}, {0.75, 0.5}})
            rows.push_back({x, 3, f.x, f.y});
    for (int i = 0; i < count; ++i)
        rows.push_back({std::floor(random.uniform(-1e6, 1e6)), std::floor(random.uniform(-50, 50)),
                        random.uniform(0, 1), random.uniform(0, 1)});
    return rows;
}

}  // namespace

CHECK_EXERCISE("11.quintic_noise",
               "s and its first two derivatives are given at both ends: six numbers for six coefficients.") {
    Probe probe{.include = "11_fractals/quintic_noise.glsl",
                .signature = "float quintic_noise(ivec2 cell, vec2 f)",
                .inputs = places(500),
                .truth =
                    [](auto in) {
                        return Row{truth::noise_truth(cell_of(in), {in[2], in[3]}).value};
                    },
                .bound = {.absolute = 3e-6},
                .hint = [](auto in, auto out) -> std::string {
                    const double cubic = truth::noise_truth(cell_of(in), {in[2], in[3]}, true).value;
                    if (std::fabs(out[0] - cubic) < 1e-4) return "This is smoothstep: its second derivative jumps.";
                    return "";
                }};
    check.probe(probe);
}

CHECK_EXERCISE("11.noise_derivative", "Differentiate the given expression by f.x; s(f.y) is a constant there.") {
    Probe probe{
        .include = "11_fractals/noise_derivative.glsl",
        .signature = "vec3 noise_derivative(ivec2 cell, vec2 f)",
        .inputs = places(500),
        .truth =
            [](auto in) {
                const truth::NoiseTruth noise = truth::noise_truth(cell_of(in), {in[2], in[3]});
                return Row{noise.value, noise.gradient.x, noise.gradient.y};
            },
        .bound = {.absolute = 1.5e-5},
        .hint = [](auto in, auto out) -> std::string {
            const truth::NoiseTruth noise = truth::noise_truth(cell_of(in), {in[2], in[3]});
            const glm::dvec2 got(out[1], out[2]);
            if (std::fabs(out[0] - noise.value) < 1e-4 && glm::length(got + noise.gradient) < 1e-3)
                return "Check the sign: the gradient points uphill.";
            if (noise.gradient.x != noise.gradient.y && glm::length(glm::dvec2(got.y, got.x) - noise.gradient) < 1e-3)
                return "x and y are exchanged.";
            return "";
        }};
    check.probe(probe);
}

CHECK_EXERCISE("11.eroded_fbm",
               "The weight depends on d, and the derivative of d by the position is the sum of hessian * scale.") {
    Probe probe{
        .include = "11_fractals/eroded_fbm.glsl",
        .signature = "vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain)",
        .truth =
            [](auto in) {
                const truth::Ground ground = truth::eroded_truth({cell_of(in), {in[2], in[3]}}, in[4], in[5], in[6]);
                return Row{ground.height, ground.slope.x, ground.slope.y};
            },
        // Each octave multiplies the rounding of the place by its cells' number, and a slope by a second derivative.
        .bound = {.absolute = 4e-4, .relative = 4e-4},
        .hint = [](auto in, auto out) -> std::string {
            const truth::Ground ground = truth::eroded_truth({cell_of(in), {in[2], in[3]}}, in[4], in[5], in[6]);
            const glm::dvec2 got(out[1], out[2]);
            const auto is = [&](glm::dvec2 wrong) { return glm::length(got - wrong) < 1e-2 * glm::length(wrong); };
            if (std::fabs(out[0] - ground.height) > 4e-4)
                return in[4] != std::floor(in[4]) ? "The share of the last octave applies to d as well."
                       : in[4] == 1               ? "A single octave has a weight, too."
                                                  : "";
            if (is(ground.unweighted)) return "The height is right, but the weight has a derivative as well.";
            if (is(ground.sum)) return "The height is right, but d is not the slope.";
            if (is(-ground.slope)) return "Check the sign: the gradient points uphill.";
            return "The height is right, but the gradient of each octave is by its own coordinates: multiply by scale "
                   "from the right.";
        }};
    for (const double octaves : {0.0, 1.0, 1.25, 2.0, 3.0, 3.5, 5.0, 6.0})
        for (const double erosion : {0.0, 0.15, 1.0, 4.0})
            for (const glm::dvec2 at : {glm::dvec2{0.3, 0.6}, {0.9, 0.125}, {3.25, -2.75}})
                probe.inputs.push_back({12, -5, at.x, at.y, octaves, erosion, 0.5});
    Random random(3);
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({std::floor(random.uniform(-1e6, 1e6)), std::floor(random.uniform(-90, 90)),
                                random.uniform(-2, 2), random.uniform(-2, 2), std::floor(random.uniform(1, 7)),
                                random.uniform(0, 2), random.uniform(0.3, 0.6)});
    // As many octaves as there can be. At places that are sixteenths of a cell nothing is rounded on the way from one
    // to the next, and so there are many left to compare.
    for (const double octaves : {0.0, 0.25, 7.0, 8.5, 11.0, 12.0, 12.5, 13.0, 14.75, 15.0, 16.0})
        for (const double erosion : {0.0, 0.15, 1.0})
            for (const glm::dvec2 at : {glm::dvec2{0.3125, 0.5625}, {0.9375, -1.1875}})
                probe.inputs.push_back({std::floor(random.uniform(-1e5, 1e5)), -5, at.x, at.y, octaves, erosion, 0.5});
    check.probe(probe);
}

CHECK_EXERCISE("11.integrate_octaves", "In octave n a wave has the length first_m / lacunarity^n: solve for n.") {
    Probe probe{.include = "11_fractals/integrate_octaves.glsl",
                .signature = "float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most)",
                .inputs = {{5000, 2, 0, 12},
                           {5000, 2, 1e-30, 12},
                           {5000, 2, 2500, 12},
                           {5000, 2, 1250, 12},
                           {5000, 2, 2600, 12},
                           {5000, 2, 1e9, 12},
                           {5000, 2, 1e30, 1},
                           {1, 2.5, 1e-3, 16},
                           {5000, 2.2360680103302, 0.5, 16},
                           {5000, 2.2360680103302, 40, 16}},
                .truth = [](auto in) { return Row{truth::integrate_octaves(in[0], in[1], in[2], in[3])}; },
                .bound = {.absolute = 2e-4, .relative = 2e-5},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[2] == 0) return "This is the logarithm of a quotient with the denominator 0.";
                    const double right = truth::integrate_octaves(in[0], in[1], in[2], in[3]);
                    if (std::fabs(out[0] - right + 1) < 0.01)
                        return "Octave 0 is the first: if it just fits, the result is 1.";
                    if (std::fabs(out[0] - std::floor(right)) < 1e-3)
                        return "The result is an integer: octaves will pop.";
                    return "";
                }};
    Random random(7);
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({random.logarithmic(1, 1e4), random.uniform(1.5, 3), random.logarithmic(1e-3, 1e4),
                                std::floor(random.uniform(1, 16))});
    const Table results = check.probe(probe);
    check.property(probe, results, "expected 1 to `most`",
                   [](auto in, auto out) { return out[0] >= 1 && out[0] <= in[3]; });
}

CHECK_EXERCISE("11.terrain_mix", "Test first which of the two lines is lower at this normal.") {
    Probe probe{
        .include = "11_fractals/terrain_mix.glsl",
        .signature = "float terrain_mix(float normal_y, float roughness, vec2 lower, vec2 upper, float strength)",
        .inputs = {{1, 0, 0.5, 1, 0.9, 1, 1},
                   {0, 0, 0.5, 1, 0.9, 1, 1},
                   {1, -0.3, 0.5, 1, 0.9, 1, 1},
                   {0.5, 0.2, 0.5, 1, 0.5, 1, 1},
                   {0.5, -0.2, 0.5, 1, 0.5, 1, 1},
                   {0.5, 0, 0.5, 1, 0.5, 1, 1},
                   {1, 0.9, 0.5, 0, 0.9, 1, 1},
                   {1, 0.2, 0.5, 0, 0.9, 1, 1},
                   {0.7, 0.1, 1.3, 1.5, 1.6, 1.6, 1},
                   {0.5, 0.5, 0.5, 1, 0.5, 1, 0},
                   {0.5, 0.5, 0.5, 1, 1.5, 1, 0},
                   {0.75, 0.5, 0.5, 1, 1.5, 1, 0.5}},
        .truth =
            [](auto in) {
                return Row{truth::terrain_mix(in[0], in[1], {in[2], in[3]}, {in[4], in[5]}, in[6])};
            },
        .bound = {.absolute = 3e-5},
        .hint = [](auto in, auto) -> std::string {
            if (in[2] - in[3] * in[0] >= in[4] - in[5] * in[0])
                return "Here full cover comes before the beginning of snow: the edge is hard.";
            return "";
        }};
    Random random(9);
    for (int i = 0; i < 400; ++i) {
        const double ny = random.uniform(0, 1), a = random.uniform(0, 2), b = random.uniform(0, 2),
                     c = random.uniform(0, 2), d = random.uniform(0, 2);
        if (std::fabs(a - b * ny - c + d * ny) < 0.02) continue;  // too steep for rounding
        const double roughness = random.uniform(-1, 1), strength = i % 2 ? random.uniform(0, 2) : 1.0;
        if (a - b * ny >= c - d * ny && std::fabs(strength * roughness - a + b * ny) < 1e-4) continue;
        probe.inputs.push_back({ny, roughness, a, b, c, d, strength});
    }
    check.probe(probe);
}
