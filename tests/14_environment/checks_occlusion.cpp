// What ./course check runs for the functions of screen-space occlusion.
#include <cmath>

#include "common/check/check.h"

using namespace lightwalk;

namespace {

// By Simpson's rule on both sides of 0, where |sin| has its corner.
double integral(double before, double after, double tilt) {
    const auto part = [&](double from, double to) {
        constexpr int pieces = 512;
        double sum = 0;
        for (int i = 0; i <= pieces; ++i) {
            const double a = from + (to - from) * i / pieces;
            sum += (i == 0 || i == pieces ? 1 : i % 2 ? 4 : 2) * std::cos(a - tilt) * std::abs(std::sin(a));
        }
        return sum * (to - from) / (3 * pieces);
    };
    return part(before, 0) + part(0, after);
}

}  // namespace

CHECK_EXERCISE("14.horizon",
               "Fade the cosine towards -1 first; then raise the horizon, or let it fall by the thickness.") {
    Probe probe{
        .include = "14_environment/horizon.glsl",
        .signature = "float raised_horizon(float horizon, float found, float away_m, float radius_m, float thickness)",
        .inputs = {{-1, 0.5, 0, 1, 0},
                   {-1, 0.5, 1, 1, 0},
                   {-1, 0.5, 2, 1, 0.5},
                   {0.7, 0.5, 0.2, 1, 0},
                   {0.7, 0.5, 0.2, 1, 0.25},
                   {0.7, 0.5, 0.2, 1, 1},
                   {0.2, 0.5, 0.5, 1, 0.25}},
        .truth =
            [](std::span<const double> in) {
                const double share = std::min(in[2] / in[3], 1.0);
                const double faded = in[1] + share * share * (-1 - in[1]);
                return Row{faded > in[0] ? faded : in[0] + in[4] * (faded - in[0])};
            },
        .bound = {.absolute = 2e-5, .relative = 1e-5},
        .hint = [](auto in, auto got) -> std::string {
            if (in[2] > in[3] && got[0] < -1)
                return "Beyond the radius nothing fades any further: limit the share to 1.";
            if (in[4] == 0 && got[0] < in[0]) return "Without thickness a horizon never falls.";
            return "";
        }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 3),
                                random.uniform(0.2, 2), i % 3 ? random.uniform(0, 1) : 0.0});
    check.probe(probe);
}

CHECK_EXERCISE("14.slice_integral",
               "Limit both horizons to a right angle from the normal; then the antiderivative on each side of 0.") {
    Probe probe{
        .include = "14_environment/slice_integral.glsl",
        .signature = "float slice_integral(float before, float after, float tilt)",
        .inputs = {{-M_PI / 2, M_PI / 2, 0},
                   {-M_PI, M_PI, 0},
                   {0, 0, 0},
                   {-M_PI / 2, 0, 0},
                   {-0.5, 0.5, 0},
                   {-M_PI, M_PI, 0.7}},
        .truth =
            [](std::span<const double> in) {
                return Row{integral(std::max(in[0], in[2] - M_PI / 2), std::min(in[1], in[2] + M_PI / 2), in[2])};
            },
        .bound = {.absolute = 2e-4, .relative = 2e-4},
        .hint = [](auto in, auto got) -> std::string {
            if (std::abs(got[0] - integral(in[0], in[1], in[2])) < 1e-3)
                return "A horizon lies below the surface here: no light arrives from there.";
            return "";
        }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back(
            {random.uniform(-M_PI, 0), random.uniform(0, M_PI), random.uniform(-M_PI / 2, M_PI / 2)});
    check.probe(probe);
}

CHECK_EXERCISE("14.bent_cone",
               "Three cases: one within the other, apart, and between; then over the lobe's own solid angle.") {
    Probe probe{.include = "14_environment/bent_cone.glsl",
                .signature = "float lobe_in_cone(float cone_rad, float lobe_rad, float between_rad)",
                .inputs = {{M_PI / 2, 0.3, 0},
                           {0, 0.3, 0},
                           {0.2, 0.4, 0},
                           {0.5, 0.3, 1.0},
                           {0.5, 0.3, 0.1},
                           {0.5, 0.3, 0.5},
                           {M_PI / 2, 0.3, M_PI / 2}},
                .truth =
                    [](std::span<const double> in) {
                        const double wider = std::max(in[0], in[1]), narrower = std::min(in[0], in[1]);
                        if (in[2] >= wider + narrower || narrower == 0) return Row{0.0};
                        const double share = std::min((wider + narrower - in[2]) / (2 * narrower), 1.0);
                        const double smooth = share * share * (3 - 2 * share);
                        return Row{std::min(smooth * (1 - std::cos(narrower)) / (1 - std::cos(in[1])), 1.0)};
                    },
                .bound = {.absolute = 2e-3, .relative = 1e-3},
                .hint = [](auto in, auto got) -> std::string {
                    if (got[0] > 1) return "No more than the whole lobe can lie within the cone.";
                    if (in[2] >= in[0] + in[1]) return "The cones do not touch here.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back(
            {random.uniform(0.01, M_PI / 2), random.uniform(0.05, M_PI / 2), random.uniform(0, M_PI)});
    check.probe(probe);
}
