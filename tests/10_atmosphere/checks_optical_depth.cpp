// Checks of 10.optical_depth: the integral itself, then the formula to its last digit.
#include <cmath>

#include "10_atmosphere/truth.h"
#include "common/check/check.h"
#include "known_air.h"

using namespace lightwalk;

namespace {

// As 10.optical_depth says it.
double optical_depth_as_told(double height, double slope, double radius, double scale) {
    const auto upwards = [&](double from, double up) {
        const double ratio = (radius + from) / scale, x = std::sqrt(0.5 * ratio) * up;
        const double s =
            x <= 8 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + 1.7245609 * x + x * x) : 0.56498823 / (0.06651874 + x);
        return scale * std::exp(-from / scale) * std::sqrt(0.5 * truth::pi * ratio) * s;
    };
    if (scale == 0) return 0;
    if (slope >= 0) return upwards(height, slope);
    const double down = (radius + height) * slope * slope / (1 + std::sqrt(1 - slope * slope));
    return 2 * upwards(std::max(height - down, 0.0), 0) - upwards(height, -slope);
}

}  // namespace

CHECK_EXERCISE("10.optical_depth",
               "Slope below 0: twice the level ray from the lowest point, minus the part behind the start.") {
    const double scales[] = {8000, 1200, 11100};
    Probe probe{
        .include = "10_atmosphere/optical_depth.glsl",
        .signature = "float optical_depth(float height, float slope, float radius, float scale_height)",
        .inputs = {{0, 1, earth, 8000},
                   {0, 0, earth, 8000},
                   {0, 0, earth, 1200},
                   {0, 0.05, earth, 1200},
                   {20000, above_horizon(20000, 0.0005), earth, 8000},
                   {90000, above_horizon(90000, 0.02), earth, 1200},
                   {0, 0.5, earth, 0},
                   {0, 0, earth, 0},
                   {4000, -0.02, earth, 0}},
        .truth = [](std::span<const double> in) { return Row{truth::optical_depth(in[0], in[1], in[2], in[3], 1500)}; },
        // The fit is good to 0.3%; below level the result is a difference of two.
        .bound = {.absolute = 1e-3, .relative = 0.012},
        .hint = [](auto in, auto) -> std::string {
            if (in[3] == 0) return "A scale height of 0 means that there is nothing.";
            return in[1] < 0 ? "" : "for a slope of 0 or more it is the formula as it stands";
        }};
    Random random;
    for (int i = 0; i < 160; ++i) {
        const double height = random.uniform(0, 60000), scale = scales[i % 3];
        probe.inputs.push_back({height, i % 2 ? random.uniform(0, 1) : above_horizon(height, random.uniform(0, 0.12)),
                                i % 5 ? earth : 3389500, scale});
    }
    std::erase_if(probe.inputs, [](const Row& in) {  // on Mars the horizon lies lower, and the ray may hit the ground
        return in[1] < -std::sqrt(in[0] * (2 * in[2] + in[0])) / (in[2] + in[0]);
    });
    check.probe(probe);

    // The formula itself, to its last digit: for all angles up and down, below the ground too, and for each of s's
    // branches.
    Probe formula = probe;
    formula.truth = [](std::span<const double> in) { return Row{optical_depth_as_told(in[0], in[1], in[2], in[3])}; };
    formula.bound = {.absolute = 1e-30, .relative = 1e-4};
    formula.hint = [](auto in, auto) -> std::string {
        if (in[1] < 0) return "Compute 2 upwards(lowest, 0) - upwards(height, -slope), where lowest is 0 or more.";
        return std::sqrt(0.5 * (in[2] + in[0]) / in[3]) * in[1] > 8 ? "x is above 8: use the other fraction."
                                                                    : "Check all digits of the fit.";
    };
    formula.inputs = {
        {0, -0.05, earth, 8000}, {0, -1, earth, 1200}, {20000, -0.5, earth, 8000}, {3000, -1, earth, 1200}};
    for (int i = 0; i < 300; ++i)
        formula.inputs.push_back(
            {random.uniform(0, 60000), random.uniform(i % 3 ? 0 : -1, 1), i % 5 ? earth : 3389500, scales[i % 3]});
    for (int i = 0; i < 100; ++i)  // on a small world x stays small
        formula.inputs.push_back({random.uniform(0, 500), random.uniform(0, 1), random.uniform(2000, 20000), 1200});
    std::erase_if(formula.inputs, [](const Row& in) {  // where s has a step
        return std::fabs(std::sqrt(0.5 * (in[2] + in[0]) / in[3]) * std::fabs(in[1]) - 8) < 1e-3;
    });
    check.probe(formula);
}
