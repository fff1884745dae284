// Checks of chapter 08's functions: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "08_bloom/exercises.h"
#include "08_bloom/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

const double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::nan("");

}  // namespace

CHECK_EXERCISE("08.soft_knee",
               "There are three cases: below the parabola, above it, and within it. Test for the first two first.") {
    Probe probe{.include = "08_bloom/soft_knee.glsl",
                .signature = "float soft_knee(float luminance, float threshold, float knee)",
                .inputs = {{0, 1, 0.5},
                           {0.5, 1, 0.5},
                           {1, 1, 0.5},
                           {1.5, 1, 0.5},
                           {3, 1, 0.5},
                           {1, 1, 0},
                           {0.99, 1, 0},
                           {2, 1, 0},
                           {0, 0, 0},
                           {0, 0, 1},
                           {4, 0, 0.5},
                           {65504, 2, 1}},
                .truth = [](std::span<const double> in) { return Row{truth::soft_knee(in[0], in[1], in[2])}; },
                .bound = {.absolute = 1e-6, .relative = 3e-6},
                .hint = [](auto in, auto) -> std::string {
                    if (in[1] * in[2] == 0) return "w is 0: there is no parabola, and 4 w must not be divided by.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 1000; ++i)
        probe.inputs.push_back({random.uniform(0, 4), random.uniform(0, 2), random.uniform(0.01, 1)});
    const Table results = check.probe(probe);
    check.property(probe, results, "but no more can pass than there is, and none below 0",
                   [](auto in, auto out) { return out[0] >= 0 && out[0] <= in[0] * (1 + 1e-6); });
}

CHECK_EXERCISE("08.bright_pass",
               "Make the radiance finite, compute its luminance, and scale it by soft_knee(luminance) / luminance.") {
    Probe probe{
        .include = "08_bloom/bright_pass.glsl",
        .signature = "vec3 bright_pass(vec3 radiance, float threshold, float knee)",
        .inputs = {{0, 0, 0, 1, 0.5},
                   {0, 0, 0, 0, 0},
                   {2, 2, 2, 1, 0.5},
                   {9, 0, 0, 1, 0.5},
                   {0, 0, 9, 1, 0},
                   {0.5, 0.5, 0.5, 1, 0.2},
                   {1, 2, 3, 0, 0},
                   {3e-5, 2e-5, 1e-5, 0, 0},
                   {0, 0, 1e-3, 0, 0},
                   {65504, 65504, 65504, 1, 0.5},
                   {infinity, 0, 0, 1, 0.5},
                   {infinity, infinity, infinity, 1, 0.5},
                   {1e9, 2, 2, 1, 0.5},
                   {not_a_number, 3, 3, 1, 0.5},
                   {not_a_number, not_a_number, not_a_number, 0, 0},
                   {-5, 3, 3, 1, 0.5},
                   {-infinity, -1, -1, 0, 0}},
        .truth = [](std::span<const double> in) { return row_of(truth::bright_pass(vector3(in), in[3], in[4])); },
        .bound = {.absolute = 2e-6, .relative = 1e-5},
        .hint = [](auto in, auto) -> std::string {
            for (int i = 0; i < 3; ++i)
                if (!std::isfinite(in[size_t(i)]) || in[size_t(i)] < 0 || in[size_t(i)] > 65504)
                    return "Use finite_light(radiance) before any other calculation.";
            if (in[0] == 0 && in[1] == 0 && in[2] == 0) return "Black has no luminance to divide by.";
            return "";
        }};
    Random random;
    for (int i = 0; i < 1000; ++i)
        probe.inputs.push_back({random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 2),
                                random.uniform(0, 1)});
    check.probe(probe);
}

CHECK_EXERCISE("08.combine",
               "Light that moves is missing where it came from; and the picture may contain infinities.") {
    Probe probe{.include = "08_bloom/combine.glsl",
                .signature = "vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes)",
                .inputs = {{1, 2, 3, 0.5, 0.5, 0.5, 0.5, 0},
                           {1, 2, 3, 0.5, 0.5, 0.5, 0.5, 1},
                           {1, 2, 3, 4, 5, 6, 0, 0},
                           {1, 2, 3, 4, 5, 6, 0, 1},
                           {1, 2, 3, 4, 5, 6, 1, 1},
                           {1, 2, 3, 4, 5, 6, 3, 0},
                           {60000, 0, 0, 60000, 0, 0, 1, 0},
                           {infinity, 0, 1, 1, 1, 1, 0.5, 0},
                           {infinity, 0, 1, 1, 1, 1, 1, 1},
                           {not_a_number, 0, 1, 1, 1, 1, 0.5, 0},
                           {not_a_number, 0, 1, 1, 1, 1, 0.5, 1},
                           {-1, 0, 1, 1, 1, 1, 0.5, 0}},
                .truth =
                    [](std::span<const double> in) {
                        const glm::dvec3 light = truth::finite_light(vector3(in));
                        const double kept = in[7] != 0 ? 1 - in[6] : 1;
                        return row_of(truth::finite_light(kept * light + in[6] * vector3(in.subspan(3))));
                    },
                .bound = {.absolute = 2e-6, .relative = 1e-5},
                .hint = [](auto in, auto out) -> std::string {
                    for (int i = 0; i < 3; ++i)
                        if (!std::isfinite(in[size_t(i)]) || !std::isfinite(out[size_t(i)]) || out[size_t(i)] > 65504)
                            return "Apply finite_light() to the radiance and to the result.";
                    return in[7] != 0 ? "Of the pixel's own light, the fraction 1 - strength stays." : "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) {
        Row row;
        for (int c = 0; c < 6; ++c) row.push_back(random.uniform(0, 8));
        row.push_back(random.uniform(0, 1));
        row.push_back(i % 2);
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("08.gaussian_weights",
               "Compute all weights, then divide each by the first plus twice the sum of the others.") {
    std::vector<float> sigmas{0.0f, 1e-30f, 1e-20f, 0.1f, 0.3f, 1.0f, 2.5f, 10.0f, 33.3f, 200.0f};
    Random random(2);
    for (int i = 0; i < 4; ++i) sigmas.push_back(static_cast<float>(random.logarithmic(0.2, 60)));
    for (const float sigma : sigmas)
        for (const float truncation : {1.0f, 2.5f, 3.0f, 5.0f}) {
            const std::string what = fmt::format("gaussian_weights({}, {})", sigma, truncation);
            check.call(what, [&]() -> std::string {
                const std::vector<float> weights = gaussian_weights(sigma, truncation);
                const size_t wanted = 1 + static_cast<size_t>(std::ceil(truncation * sigma));
                if (weights.size() != wanted)
                    return fmt::format("{} gave {} weights, expected {}", what, weights.size(), wanted);
                double sum = 0;
                for (size_t d = 0; d < wanted; ++d) {
                    if (!std::isfinite(weights[d])) return fmt::format("{}: weight {} is {}", what, d, weights[d]);
                    sum += (d == 0 ? 1 : 2) * double(weights[d]);
                }
                if (std::fabs(sum - 1) > 1e-6)
                    return fmt::format("{}: both sides add up to {:.6f}, expected 1: the picture becomes {}", what, sum,
                                       sum < 1 ? "darker" : "brighter");
                for (size_t d = 1; d < wanted; ++d) {
                    const double at = double(d) / double(sigma), right = double(weights[0]) * std::exp(-0.5 * at * at);
                    if (std::fabs(double(weights[d]) - right) > 1e-5 * right + 1e-30)
                        return fmt::format("{}: weight {} is {}, expected {} for a first of {}", what, d, weights[d],
                                           right, weights[0]);
                }
                return "";
            });
        }
}

CHECK_EXERCISE(
    "08.pair_taps",
    "For weights a and b of a pair, the offset is that of the first pixel plus b / (a + b), and the weight a + b.") {
    std::vector<std::vector<float>> tables{{1}, {0.5f, 0.25f}, {0.4f, 0.2f, 0.1f}, {0, 0, 0, 0}, {1, 0, 0, 0, 0}};
    tables.push_back({0.5f, 0.25f, 0.0f, 0.0f, 0.0f});
    for (const float sigma : {0.5f, 2.0f, 7.0f, 20.0f}) {
        std::vector<float> weights;
        for (int d = 0; d <= int(3 * sigma); ++d) weights.push_back(std::exp(-0.5f * float(d * d) / (sigma * sigma)));
        for (float& weight : weights) weight /= 2.6f * sigma;  // approximate sum of a Gaussian
        tables.push_back(weights);
    }
    for (const float sigma : {2.0f, 7.0f})  // far beyond the float range of a Gaussian
        for (const int reach : {5, 16}) {
            std::vector<float> weights;
            for (float d = 0; d <= float(reach) * sigma; ++d)
                weights.push_back(std::exp(-0.5f * d * d / (sigma * sigma)) / (2.6f * sigma));
            tables.push_back(weights);
        }
    Random random(3);
    for (size_t count = 2; count < 26; count += 3) {
        std::vector<float> weights;
        for (size_t d = 0; d < count; ++d) weights.push_back(static_cast<float>(random.uniform(0.01, 0.1)));
        tables.push_back(weights);
    }
    for (const std::vector<float>& weights : tables) {
        std::string list;
        for (size_t i = 0; i < std::min<size_t>(weights.size(), 6); ++i)
            list += fmt::format("{}{}", i ? ", " : "", weights[i]);
        const std::string what = fmt::format("pair_taps({{{}{}}})", list, weights.size() > 6 ? ", ..." : "");
        check.call(what, [&]() -> std::string {
            const std::vector<glm::vec2> taps = pair_taps(weights);
            const size_t wanted = 1 + weights.size() / 2;
            std::vector<double> given(weights.size() + 1, 0.0);
            for (size_t i = 0; i < taps.size(); ++i) {
                const double at = double(taps[i].x), f = at - std::floor(at);
                if (!std::isfinite(taps[i].x) || !std::isfinite(taps[i].y))
                    return fmt::format("{}: tap {} is ({}, {})", what, i, taps[i].x, taps[i].y);
                const auto k = static_cast<size_t>(std::max(at, 0.0));
                if (at < 0 || k >= weights.size() || (f > 0 && k + 1 >= weights.size()))
                    return fmt::format("{}: tap {} stands at {}, which reads beyond the last pixel {}", what, i, at,
                                       weights.size() - 1);
                given[k] += (1 - f) * double(taps[i].y);
                given[k + 1] += f * double(taps[i].y);
            }
            for (size_t d = 0; d < weights.size(); ++d)
                if (std::fabs(given[d] - double(weights[d])) > 2e-6)
                    return fmt::format("{}: through the filter pixel {} gets {:.6f}, expected {}", what, d, given[d],
                                       weights[d]);
            if (taps.size() != wanted)
                return fmt::format("{} gave {} taps, expected {}: two pixels share a read", what, taps.size(), wanted);
            return "";
        });
    }
}
