// Checks of chapter 12's shader functions: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "12_skin/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

CHECK_EXERCISE("12.gaussian_profile", "A Gaussian of variance v per axis is exp(-r²/2v) / (2 pi v) over a plane.") {
    Probe probe{.include = "12_skin/gaussian_profile.glsl",
                .signature = "vec3 gaussian_profile(float r_mm)",
                .inputs = {{0}, {0.01}, {0.08}, {0.22}, {0.5}, {1}, {2.72}, {8}, {30}},
                .truth = [](std::span<const double> in) { return row_of(truth::profile(in[0])); },
                .bound = {.absolute = 1e-9, .relative = 2e-5},
                .hint = [](auto in, auto out) -> std::string {
                    const glm::dvec3 right = truth::profile(in[0]);
                    const double ratio = out[0] / right.x;
                    if (std::fabs(ratio - 2 * truth::skin_pi) < 0.01)
                        return "Divide by 2 pi v: the integral has to be 1.";
                    if (in[0] == 0 && ratio > 1.5 && ratio < 2.5) return "The factor 1 / (pi v) belongs to exp(-r²/v).";
                    if (in[0] == 0 && out[0] < right.x / 3)
                        return "Over a plane the factor is 1 / (2 pi v), not its root.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) probe.inputs.push_back({random.logarithmic(0.005, 12)});
    check.probe(probe);
    // The integral over the plane, in rings.
    Probe rings = probe;
    rings.inputs.clear();
    constexpr int count = 4000;
    const auto radius = [](int i) { return 16.0 * (double(i) + 0.5) / count * (double(i) + 0.5) / count; };
    for (int i = 0; i < count; ++i) rings.inputs.push_back({double(float(radius(i)))});
    const Table found = check.probe(rings);
    for (size_t c = 0; c < 3 && found.size() == count; ++c) {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const double from = 16.0 * i / count * i / count, to = 16.0 * (i + 1) / count * (i + 1) / count;
            sum += found[size_t(i)][c] * truth::skin_pi * (to * to - from * from);
        }
        check.expect(std::fabs(sum - 1) < 2e-3, fmt::format("over the plane {} adds up to {:.4f}, expected 1",
                                                            std::array{"red", "green", "blue"}[c], sum));
    }
}

CHECK_EXERCISE("12.stretch_scale", "Texels per mm is the inverse of mm per texel; a length of 0 has none.") {
    Probe probe{.include = "12_skin/stretch_scale.glsl",
                .signature = "vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels)",
                .inputs = {{1, 0, 0, 0, 1, 0, 32},
                           {0.5, 0, 0, 0, 0.25, 0, 32},
                           {0, 0, 0, 0, 0, 0, 32},
                           {0, 0, 0, 0, 2, 0, 32},
                           {1e-30, 0, 0, 0, 1, 0, 16},
                           {0.3, 0.4, 0, 0, 0.6, 0.8, 32},
                           {0.01, 0, 0, 0.1, 0, 0, 32},
                           {10, 0, 0, 1, 1, 0, 4},
                           {0, 0, 0, 0, 0, 0, 7},
                           {0, 0.001, 0, 0, 0, 0.002, 700}},
                .truth =
                    [](std::span<const double> in) {
                        const auto scale = [&](size_t at) {
                            const double length = glm::length(vector3(in.subspan(at)));
                            return length * in[6] > 1 ? 1 / length : in[6];
                        };
                        return Row{scale(0), scale(3)};
                    },
                .bound = {.absolute = 1e-6, .relative = 1e-5},
                .hint = [](auto in, auto out) -> std::string {
                    const double du = glm::length(vector3(in)), dv = glm::length(vector3(in.subspan(3)));
                    if (du == 0 || dv == 0) return "A step of length 0 gives most_texels.";
                    if (std::fabs(out[0] - du) < 1e-5 * du && std::fabs(out[1] - dv) < 1e-5 * dv)
                        return "This is mm per texel; the result is texels per mm.";
                    if (out[0] > in[6] || out[1] > in[6]) return "No component may be above most_texels.";
                    return "x depends only on du_mm, y only on dv_mm.";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) {
        Row row;
        for (int c = 0; c < 6; ++c) row.push_back(random.uniform(-1, 1) * (i % 3 ? 1 : 0.02));
        row.push_back(random.uniform(4, 40));
        for (double& x : row) x = double(float(x));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("12.chart_step",
               "How many steps lie between the two places, and how many of them does the division expect?") {
    Probe probe{.include = "12_skin/chart_step.glsl",
                .signature = "vec3 chart_step(vec4 before, vec4 own, vec4 after)",
                .inputs = {{0, 0, 0, 1, 0.001, 0, 0, 1, 0.002, 0, 0, 1},
                           {0, 0, 0, 1, 0.001, 0, 0, 1, 0.004, 0, 0, 1},
                           {0, 0, 0, 1, 0.001, 0, 0, 1, 0.5, 0.5, 0.5, 2},
                           {0.5, 0.5, 0.5, 2, 0.001, 0, 0, 1, 0.003, 0, 0, 1},
                           {0.5, 0.5, 0.5, 2, 0.001, 0, 0, 1, 0, 0, 0, 0},
                           {0.5, 0.5, 0.5, 2, 0.001, 0, 0, 1, 0.7, 0, 0, 2}},
                .truth =
                    [](std::span<const double> in) {
                        glm::dvec3 sum(0);
                        int steps = 0;
                        const glm::dvec3 own = vector3(in.subspan(4));
                        if (in[3] == in[7]) {
                            sum += own - vector3(in);
                            ++steps;
                        }
                        if (in[11] == in[7]) {
                            sum += vector3(in.subspan(8)) - own;
                            ++steps;
                        }
                        return row_of(steps ? 1000.0 * sum / double(steps) : sum);
                    },
                .bound = {.absolute = 2e-3, .relative = 1e-4},
                .hint = [](auto in, auto) -> std::string {
                    const bool first = in[3] == in[7], second = in[11] == in[7];
                    if (first != second) return "Here one neighbour is of the same chart: there is one step.";
                    if (!first) return "Both neighbours are of another chart: no step is known.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 300; ++i) {
        Row row;
        for (int texel = 0; texel < 3; ++texel) {
            for (int axis = 0; axis < 3; ++axis) row.push_back(random.uniform(-0.1, 0.1));
            row.push_back(1 + int(random.uniform(0, 2)));
        }
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("12.mix_albedo", "The powers are s and 1 - s; pow(0, 0) is undefined.") {
    for (const bool after : {false, true}) {
        Probe probe{
            .include = "12_skin/mix_albedo.glsl",
            .signature = after ? "vec3 albedo_after(vec3 albedo, float s)" : "vec3 albedo_before(vec3 albedo, float s)",
            .inputs = {{0, 0, 0, 0},
                       {0, 0, 0, 1},
                       {0, 0, 0, 0.5},
                       {1, 1, 1, 0.5},
                       {0, 0.5, 1, 0},
                       {0, 0.5, 1, 1},
                       {0.25, 0.16, 0.04, 0.5},
                       {0.8, 0.5, 0.4, 0.25},
                       {1e-6, 1e-3, 0.5, 0.5}},
            .truth =
                [after](std::span<const double> in) {
                    const double power = after ? 1 - in[3] : in[3];
                    glm::dvec3 result(1);
                    for (int c = 0; c < 3; ++c)
                        if (power > 0) result[c] = std::pow(in[size_t(c)], power);
                    return row_of(result);
                },
            .bound = {.absolute = 1e-6, .relative = 2e-5},
            .hint = [after](auto in, auto) -> std::string {
                const double power = after ? 1 - in[3] : in[3];
                if (power == 0) return "The power is 0: return 1 without pow.";
                return after ? "After the blur the power is 1 - s." : "Before the blur the power is s.";
            }};
        Random random;
        for (int i = 0; i < 300; ++i)
            probe.inputs.push_back(
                {random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0, 1)});
        check.probe(probe);
    }
}

CHECK_EXERCISE("12.transmittance", "exp(-s²/v) without a half and without a factor; a thickness below 0 counts as 0.") {
    Probe probe{.include = "12_skin/transmittance.glsl",
                .signature = "vec3 transmittance(float thickness_mm)",
                .inputs = {{0}, {-0.5}, {-100}, {0.1}, {0.5}, {1}, {2}, {5}, {9}, {40}, {1e4}},
                .truth = [](std::span<const double> in) { return row_of(truth::transmittance(in[0])); },
                .bound = {.absolute = 1e-7, .relative = 2e-5},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[0] < 0) return "A thickness below 0 counts as 0: a shadow map is not exact.";
                    if (in[0] == 0 && out[0] < 0.9)
                        return "Through a thickness of 0 all light passes: there is no factor before exp.";
                    if (in[0] == 0 && out[0] > 1.1) return "Through a thickness of 0 no more than all light passes.";
                    return "The exponent is -s² / v, not half of it.";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) probe.inputs.push_back({random.uniform(-1, 10)});
    check.probe(probe);
}
