// Checks of chapter 09's functions of one pixel: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "09_post_effects/tone_truth.h"
#include "09_post_effects/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Row color(Random& random, double most) {
    return {random.uniform(0, most), random.uniform(0, most), random.uniform(0, most)};
}

}  // namespace

CHECK_EXERCISE("09.exposure_gamma", "Use exp2() for the stops; a gamma of 0 or less has no power.") {
    Random random;
    Probe exposed{
        .include = "09_post_effects/exposure_gamma.glsl",
        .signature = "vec3 expose(vec3 radiance, float stops)",
        .inputs = {{1, 2, 3, 0}, {1, 2, 3, 1}, {1, 2, 3, -1}, {0, 0, 0, 16}, {0.5, 0.25, 4, -16}, {1, 1, 1, 16}},
        .truth = [](std::span<const double> in) { return row_of(std::exp2(in[3]) * vector3(in)); },
        .bound = {.absolute = 1e-9, .relative = 2e-5},
        .hint = [](auto, auto) { return "A stop is a factor of two, not a sum or a power of e."; }};
    for (int i = 0; i < 200; ++i) {
        exposed.inputs.push_back(color(random, 8));
        exposed.inputs.back().push_back(random.uniform(-8, 8));
    }
    check.probe(exposed);

    Probe curved{.include = "09_post_effects/exposure_gamma.glsl",
                 .signature = "vec3 apply_gamma(vec3 color, float gamma)",
                 .inputs = {{0, 0.5, 1, 1},
                            {0, 0.5, 1, 2.2},
                            {0, 0.5, 1, 0.5},
                            {0.25, 0.5, 4, 0},
                            {0, 0.5, 1, -1},
                            {-0.1, 0.5, 1, 2},
                            {0, 0, 0, 8},
                            {0.2, 0.5, 2, -0.001}},
                 .truth = [](std::span<const double> in) { return row_of(truth::apply_gamma(vector3(in), in[3])); },
                 .bound = {.absolute = 2e-5, .relative = 1e-4},
                 .hint = [](auto in, auto) -> std::string {
                     if (in[3] <= 0) return "For a gamma of 0 or less return the colour unchanged.";
                     for (int c = 0; c < 3; ++c)
                         if (in[size_t(c)] < 0)
                             return "A power of a negative number is undefined: light below 0 counts as 0.";
                     return "A gamma above 1 brightens: the power is 1 / gamma.";
                 }};
    for (int i = 0; i < 300; ++i) {
        curved.inputs.push_back(color(random, 2));
        curved.inputs.back().push_back(random.uniform(0.2, 4));
    }
    check.probe(curved);
}

CHECK_EXERCISE("09.contrast_saturation",
               "Contrast is a power around middle grey, saturation a straight line through the grey of the colour.") {
    Random random;
    Probe power{.include = "09_post_effects/contrast_saturation.glsl",
                .signature = "vec3 contrast(vec3 color, float amount)",
                .inputs = {{0.18, 0.09, 0.36, 2},
                           {0.18, 0.09, 0.36, 1},
                           {0, 0.18, 1, 0},
                           {0, 0, 0, 0},
                           {0, 0.5, 1, 3},
                           {-0.2, 0.5, 1, 1.5},
                           {0.01, 0.1, 4, 0.5}},
                .truth = [](std::span<const double> in) { return row_of(truth::contrast(vector3(in), in[3])); },
                .bound = {.absolute = 1e-5, .relative = 2e-4},
                .hint = [](auto in, auto) -> std::string {
                    if (in[3] == 0) return "pow(0, 0) is undefined and is used here; treat an amount of 0 separately.";
                    for (int c = 0; c < 3; ++c)
                        if (in[size_t(c)] < 0)
                            return "A power of a negative number is undefined: light below 0 counts as 0.";
                    return "0.18 must stay 0.18 for any amount.";
                }};
    Probe line{
        .include = "09_post_effects/contrast_saturation.glsl",
        .signature = "vec3 saturate_color(vec3 color, float amount)",
        .inputs = {{1, 0.5, 0.25, 1}, {1, 0.5, 0.25, 0}, {1, 0, 0, 4}, {0, 0, 1, 2}, {0, 0, 0, 4}, {3, 3, 3, 2}},
        .truth = [](std::span<const double> in) { return row_of(truth::saturate_color(vector3(in), in[3])); },
        .bound = {.absolute = 2e-6, .relative = 2e-5},
        .hint = [](auto, auto out) -> std::string {
            for (const double c : out)
                if (c < 0) return "Light is never below 0.";
            return "Use mix() from the grey of the same luminance to the colour; an amount above 1 extrapolates.";
        }};
    for (int i = 0; i < 200; ++i) {
        Row row = color(random, 3);
        row.push_back(random.uniform(0.05, 4));
        power.inputs.push_back(row);
        line.inputs.push_back(row);
    }
    check.probe(power);
    check.probe(line);
}

CHECK_EXERCISE("09.vignette", "Measure the distance in pixels: multiply x by the aspect before taking the length.") {
    Random random;
    Probe probe{.include = "09_post_effects/vignette.glsl",
                .signature = "float vignette(vec2 uv, float aspect, float strength, float power)",
                .inputs = {{0.5, 0.5, 1.78, 0.5, 2},
                           {0.5, 0.5, 1.78, 0.5, 0},
                           {0.2, 0.3, 1.78, 0.5, 0},
                           {0, 0, 1.78, 0.5, 2},
                           {1, 1, 0.5, 1, 1},
                           {1, 0.5, 2, 1, 1},
                           {0.5, 1, 2, 1, 1},
                           {0.5, 0.5, 1, 1, 0.1}},
                .truth =
                    [](std::span<const double> in) {
                        return Row{truth::vignette({in[0], in[1]}, in[2], in[3], in[4])};
                    },
                .bound = {.absolute = 2e-5},
                .hint = [](auto in, auto) -> std::string {
                    if (in[4] == 0) return "At a power of 0 all pixels are equal; and pow(0, 0) is undefined.";
                    if (in[0] == 0.5 && in[1] == 0.5)
                        return "The middle has no direction to normalise; a length is enough.";
                    return "";
                }};
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0.3, 3),
                                random.uniform(0, 1), random.uniform(0.2, 8)});
    check.probe(probe);
}

CHECK_EXERCISE("09.chromatic_aberration",
               "r squared is a dot product divided by that of a corner; then one more division.") {
    Random random;
    Probe probe{
        .include = "09_post_effects/chromatic_aberration.glsl",
        .signature = "vec2 aberrated(vec2 uv, float shift)",
        .inputs =
            {{0.5, 0.5, 0.1}, {0.5, 0.5, -0.1}, {0, 0, 0.1}, {1, 1, 0.2}, {1, 0, -0.2}, {0.3, 0.8, 0}, {0, 0.5, 0.2}},
        .truth =
            [](std::span<const double> in) {
                const glm::dvec2 at = truth::aberrated({in[0], in[1]}, in[2]);
                return Row{at.x, at.y};
            },
        .bound = {.absolute = 1e-6},
        .hint = [](auto in, auto) -> std::string {
            if (in[0] == 0.5 && in[1] == 0.5)
                return "The middle stays where it is; it has no direction and needs none.";
            return in[2] > 0 ? "For a shift above 0 divide everything by the factor of a corner." : "";
        }};
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(-0.2, 0.2)});
    const Table results = check.probe(probe);
    check.property(probe, results, "which lies outside of the picture", [](auto, auto at) {
        return at[0] >= -1e-6 && at[1] >= -1e-6 && at[0] <= 1 + 1e-6 && at[1] <= 1 + 1e-6;
    });
}

CHECK_EXERCISE("09.circle_of_confusion", "(z - f) / z is 1 - f / z, which is finite for an infinite z.") {
    Random random;
    const double infinity = std::numeric_limits<double>::infinity();
    Probe probe{.include = "09_post_effects/circle_of_confusion.glsl",
                .signature =
                    "float circle_of_confusion(float z, float focus_m, float focal_m, float f_number, float sensor_m, "
                    "float height_px, float most_px)",
                .inputs = {{2, 2, 0.05, 2, 0.024, 1080, 100},
                           {infinity, 2, 0.05, 2, 0.024, 1080, 100},
                           {infinity, 0.05, 0.05, 2, 0.024, 1080, 100},
                           {0.04, 0.05, 0.05, 2, 0.024, 1080, 100},
                           {1, 0.01, 0.05, 2, 0.024, 1080, 100},
                           {0.5, 2, 0.05, 2, 0.024, 1080, 1000},
                           {8, 2, 0.05, 2, 0.024, 1080, 0},
                           // Nearer than 1.01 F, and so small a disc that nothing is clamped.
                           {infinity, 0.005, 0.01, 22, 0.05, 100, 1000},
                           {infinity, 0.01, 0.01, 22, 0.05, 100, 1000},
                           {infinity, 0.01005, 0.01, 22, 0.05, 100, 1000},
                           {0.02, 0.01, 0.01, 22, 0.05, 100, 1000},
                           {0.009, 0.005, 0.01, 22, 0.05, 100, 1000},
                           {1e-3, 2, 0.05, 1.4, 0.024, 2160, 300}},
                .truth =
                    [](std::span<const double> in) {
                        return Row{truth::circle_of_confusion(in[0], in[1], in[2], in[3], in[4], in[5], in[6])};
                    },
                .bound = {.absolute = 2e-3, .relative = 2e-4},
                .hint = [infinity](auto in, auto) -> std::string {
                    if (in[0] == infinity) return "Infinity divided by infinity is NaN: divide before you subtract.";
                    if (in[1] < 1.01 * in[2]) return "A focus below 1.01 F counts as 1.01 F, wherever f occurs.";
                    return in[0] < in[1] ? "The result is negative in front of the plane of focus."
                                         : "Convert metres to pixels: / sensor_m * height_px.";
                }};
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back({random.logarithmic(0.1, 1000), random.logarithmic(0.1, 100), random.uniform(0.01, 0.2),
                                random.uniform(0.7, 22), random.uniform(0.01, 0.05), random.uniform(100, 4320),
                                random.uniform(1, 1000)});
    for (int i = 0; i < 200; ++i) {  // around the nearest focus, where few pixels leave something to see of the disc
        const double focal = random.uniform(0.008, 0.02);
        probe.inputs.push_back({focal * random.logarithmic(0.5, 100), double(float(focal * random.uniform(0.5, 1.1))),
                                focal, random.uniform(11, 22), 0.05, random.uniform(20, 60), 1000});
    }
    check.probe(probe);
}

CHECK_EXERCISE("09.tone_curve", "Matrix, curve, matrix; then a clamp at both ends.") {
    Random random;
    Probe probe{
        .include = "09_post_effects/tone_curve.glsl",
        .signature = "vec3 tone_curve(vec3 radiance)",
        .inputs = {{0, 0, 0},
                   {0.18, 0.18, 0.18},
                   {1, 1, 1},
                   {65504, 65504, 65504},
                   {50, 0, 0},
                   {0, 50, 0},
                   {0, 0, 50},
                   {65504, 0, 0},
                   {0, 65504, 0},
                   {0, 0, 65504},
                   {65504, 65504, 0},
                   {1e-4, 0, 1e-4}},
        .truth = [](std::span<const double> in) { return row_of(truth::hill(vector3(in))); },
        .bound = {.absolute = 2e-5},
        .hint = [](auto, auto out) -> std::string {
            for (const double c : out)
                if (c < 0)
                    return "The curve is slightly below 0 for black, and a power of that is NaN: clamp the result.";
            for (const double c : out)
                if (c > 1) return "A result above 1 is brighter than the white of the screen: clamp it.";
            return "Input matrix, curve for each channel, output matrix, in this order.";
        }};
    for (int i = 0; i < 300; ++i)
        probe.inputs.push_back(
            {random.logarithmic(1e-4, 100), random.logarithmic(1e-4, 100), random.logarithmic(1e-4, 100)});
    for (int i = 0; i < 150; ++i) {  // up to the brightest, single colours too
        Row row(3, 0.0);
        row[size_t(i % 3)] = random.logarithmic(1, 65504);
        if (i % 2) row[size_t(i + 1) % 3] = random.logarithmic(1e-4, 65504);
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
