// Checks of chapter 16's functions: values against double precision, then properties.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <numbers>

#include "16_volume/exercises.h"
#include "16_volume/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("16.correct_opacity", "transmittances multiply: 1 - opacity to the power of the ratio") {
    Probe probe{.include = "16_volume/correct_opacity.glsl",
                .signature = "float correct_opacity(float opacity, float ratio)",
                .inputs = {{0.5, 1},
                           {0.5, 2},
                           {0.5, 0.5},
                           {0.5, 0},
                           {0, 0},
                           {0, 1},
                           {0, 5},
                           {1, 1},
                           {1, 7},
                           {1, 0.001},
                           {1, 1e-6},
                           {1, 0},
                           // Nearly opaque, nearly no length, and a great one.
                           {0.99999, 0.01},
                           {0.75, 1e-4},
                           {0.25, 1e4},
                           {0.001, 1000}},
                .truth = [](auto in) { return Row{truth::correct_opacity(in[0], in[1])}; },
                .bound = {.absolute = 2e-5},
                // pow(x, y) is exp2(y * log2(x)), and Vulkan lets log2 err by 2^-21 between 0.5 and 2.
                .grants =
                    [](auto in, auto out) {
                        const double right = truth::correct_opacity(in[0], in[1]);
                        return std::fabs(out[0] - right) <= std::numbers::ln2 * 0x1p-21 * in[1] * (1 - right);
                    },
                .hint = [](auto in, auto out) -> std::string {
                    if (in[0] == 1)
                        return "opaque is opaque at any length but none; pow(0, 0) and log(0) are not defined";
                    if (std::fabs(out[0] - in[0] * in[1]) < 1e-5)
                        return "opacities do not add up: two layers of 0.8 would absorb more than all";
                    if (std::fabs(out[0] - std::pow(in[0], in[1])) < 1e-5)
                        return "that is the power of the opacity: it is the transmittances that multiply";
                    return "";
                }};
    Random random(3);
    for (int i = 0; i < 300; ++i) probe.inputs.push_back({random.uniform(0, 1), random.logarithmic(1e-3, 50)});
    check.probe(probe);
}

CHECK_EXERCISE("16.composite_front_to_back", "what a sample adds is weakened by what lies before it: times so_far.a") {
    Probe probe{.include = "16_volume/composite_front_to_back.glsl",
                .signature = "vec4 composite_front_to_back(vec4 so_far, vec3 radiance, float opacity)",
                .inputs = {{0, 0, 0, 1, 1, 2, 3, 0.25},
                           {1, 1, 1, 0.5, 4, 2, 0, 0.5},
                           {1, 2, 3, 0, 9, 9, 9, 1},
                           {0, 0, 0, 1, 5, 5, 5, 0},
                           {0.1, 0.2, 0.3, 0.9, 1, 1, 1, 1}},
                .truth =
                    [](auto in) {
                        Row out;
                        for (size_t c = 0; c < 3; ++c) out.push_back(in[c] + in[3] * in[7] * in[4 + c]);
                        out.push_back(in[3] * (1 - in[7]));
                        return out;
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-5},
                .hint = [](auto in, auto out) -> std::string {
                    if (std::fabs(out[3] - in[3] * in[7]) < 1e-6 && in[7] != 0.5)
                        return "a is what gets through, not what is held back";
                    if (std::fabs(out[0] - in[0] - in[7] * in[4]) < 1e-6 && in[3] < 1)
                        return "what lies before it weakens it";
                    if (std::fabs(out[0] - in[0] - in[3] * in[4]) < 1e-6 && in[7] < 1)
                        return "it shines as far as it is opaque: the radiance is not weighted yet";
                    return "";
                }};
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        Row row;
        for (int c = 0; c < 3; ++c) row.push_back(random.uniform(0, 4));
        row.push_back(random.uniform(0, 1));
        for (int c = 0; c < 3; ++c) row.push_back(random.uniform(0, 9));
        row.push_back(random.uniform(0, 1));
        probe.inputs.push_back(row);
    }
    check.probe(probe);

    Probe finished{.include = "16_volume/composite_front_to_back.glsl",
                   .signature = "bool is_finished(float transmittance, float brightest, float threshold)",
                   .inputs = {{1, 1, 0.002},
                              {0.01, 1, 0.002},
                              {0.0019, 1, 0.002},
                              {0.0019, 50, 0.002},
                              {0.00003, 50, 0.002},
                              {0.01, 0.1, 0.002},
                              {1, 0, 0.002},
                              {0, 1000, 0.002},
                              {0.5, 1, 0.5},  // as much as the threshold, and not more
                              {1, 0.001, 0.01}},
                   .truth = [](auto in) { return Row{in[0] * in[1] <= in[2] ? 1.0 : 0.0}; },
                   .bound = {.absolute = 0.5},
                   .hint = [](auto in, auto out) -> std::string {
                       if (out[0] != 0 && in[1] > 1) return fmt::format("a lamp of {} behind would still show", in[1]);
                       if (in[0] * in[1] == in[2]) return "a change by the threshold itself is not more than it";
                       if (out[0] == 0 && in[1] < 1) return "nothing behind is bright enough to show";
                       return "";
                   }};
    for (int i = 0; i < 200; ++i) {
        const double t = random.logarithmic(1e-6, 1), b = random.logarithmic(0.01, 100),
                     e = random.logarithmic(1e-4, 0.1);
        if (std::fabs(t * b / e - 1) > 1e-3) finished.inputs.push_back({t, b, e});
    }
    check.probe(finished);
}

CHECK_EXERCISE("16.noise_4d", "16 corners, each weighted by the product of four numbers that are s(t) or 1 - s(t)") {
    Probe probe{.include = "16_volume/noise_4d.glsl",
                .signature = "float noise_4d(ivec4 cell, vec4 f)",
                .truth =
                    [](auto in) {
                        return Row{truth::noise_4d({int(in[0]), int(in[1]), int(in[2]), int(in[3])},
                                                   {in[4], in[5], in[6], in[7]})};
                    },
                .bound = {.absolute = 5e-6},
                .hint = [](auto in, auto out) -> std::string {
                    const glm::ivec4 cell{int(in[0]), int(in[1]), int(in[2]), int(in[3])};
                    const glm::dvec4 f{in[4], in[5], in[6], in[7]};
                    if (std::fabs(out[0] - truth::noise_4d(cell, f, truth::Weight::linear)) < 1e-4)
                        return "those are linear weights: the noise has creases at the cells' faces";
                    if (std::fabs(out[0] - truth::noise_4d(cell, f, truth::Weight::cubic)) < 1e-4)
                        return "that is smoothstep: its second derivative has a step";
                    return "";
                }};
    Random random(5);
    for (const double time : {0.0, 604800.0, -1.0, 2147483646.0})
        for (const double f : {0.0, 0.5, 1.0}) probe.inputs.push_back({1, -2, 3, time, f, 0.25, 1 - f, f});
    for (int i = 0; i < 16; ++i)
        probe.inputs.push_back({5, 6, 7, 8, double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1), double(i >> 3)});
    for (int i = 0; i < 400; ++i) {
        Row row;
        for (int k = 0; k < 4; ++k) row.push_back(std::floor(random.uniform(-1e6, 1e6)));
        for (int k = 0; k < 4; ++k) row.push_back(random.uniform(0, 1));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("16.gradient", "two densities along each axis, one voxel of that axis away; over two voxels in metres") {
    // Known densities: one that is straight, and two that are not.
    for (const char* density : {"(0.1 + at.x + 2.0 * at.y - 3.0 * at.z)", "(at.x * at.x * at.y + at.z * at.z)",
                                "sin(3.0 * at.x + 2.0 * at.y + at.z)"}) {
        Probe probe{.include = "16_volume/gradient.glsl",
                    .before = "#include \"../tests/16_volume/known_density.glsl\"\n",
                    .signature = "vec3 gradient(vec3 at, vec3 voxel, vec3 voxel_m)",
                    .truth =
                        [&](auto in) {
                            const std::string name = density;
                            const auto value = [&](glm::dvec3 at) {
                                if (name[0] == 's') return std::sin(3 * at.x + 2 * at.y + at.z);
                                return name[1] == '0' ? 0.1 + at.x + 2 * at.y - 3 * at.z
                                                      : at.x * at.x * at.y + at.z * at.z;
                            };
                            Row out;
                            for (int axis = 0; axis < 3; ++axis) {
                                glm::dvec3 step(0);
                                step[axis] = in[size_t(3 + axis)];
                                out.push_back((value(vector3(in) + step) - value(vector3(in) - step)) /
                                              (2 * in[size_t(6 + axis)]));
                            }
                            return out;
                        },
                    .bound = {.absolute = 2e-3, .relative = 2e-3},
                    .macros = {{"KNOWN_DENSITY", density}},
                    .hint = [](auto in, auto out) -> std::string {
                        const auto is = [&](double factor) {
                            return std::fabs(out[0] * factor) > 1e-6 && in[3] != in[4] && factor != 1;
                        };
                        if (in[6] != in[7] && is(2))
                            return "each axis has its own voxel: its step, and its length in metres";
                        return "";
                    }};
        Random random(6);
        for (int i = 0; i < 120; ++i) {
            Row row{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
            const bool even = i % 4 == 0;
            const double size = random.uniform(0.02, 0.2), metres = random.uniform(0.02, 0.2);
            for (int k = 0; k < 3; ++k) row.push_back(even ? size : random.uniform(0.02, 0.2));
            for (int k = 0; k < 3; ++k) row.push_back(even ? metres : random.uniform(0.02, 0.2));
            probe.inputs.push_back(row);
        }
        check.probe(probe);
        if (check.failed) return;
    }
}

CHECK_EXERCISE("16.preintegrate",
               "cut the step into layers of almost one density and composite them, the nearest first") {
    Random random(7);
    for (int kind = 0; kind < 5; ++kind) {
        // Even; smooth; one entry alone; opaque from the middle on; a colour that changes.
        std::vector<glm::vec4> transfer;
        const int entries = kind == 1 ? 256 : kind == 3 ? 2 : 64;
        for (int i = 0; i < entries; ++i) {
            const float x = float(i) / float(entries - 1);
            transfer.push_back(kind == 0   ? glm::vec4(1, 0.5, 0.25, 0.1)
                               : kind == 1 ? glm::vec4(x, 1 - x, 2, 0.3f * x * x)
                               : kind == 2 ? glm::vec4(1, 1, 1, i == 40 ? 0.7f : 0.0f)
                               : kind == 3 ? glm::vec4(3, 1, 0, 0.95f * float(i))
                                           : glm::vec4(i < 32 ? 1 : 0, i < 32 ? 0 : 4, 0, 0.4));
        }
        float brightest = 0;
        for (const glm::vec4& entry : transfer) brightest = std::max({brightest, entry.x, entry.y, entry.z});
        for (int i = 0; i < 40; ++i) {
            const float front = i < 4 ? float(i & 1) : float(random.uniform(0, 1));
            const float back = i < 4 ? float(i >> 1) : i % 5 == 0 ? front : float(random.uniform(0, 1));
            const float ratio = i == 7 ? 0.0f : float(random.logarithmic(0.01, i % 3 ? 5 : 100));
            const std::string what = fmt::format("preintegrate(a function of {} entries, {:.3f}, {:.3f}, {:.3f})",
                                                 entries, front, back, ratio);
            check.call(what, [&]() -> std::string {
                const glm::dvec4 got(preintegrate(transfer, front, back, ratio));
                const glm::dvec4 right = truth::preintegrate(transfer, double(front), double(back), double(ratio));
                const double allowed = 0.002 * std::max(1.0, double(brightest));
                for (int c = 0; c < 4; ++c)
                    if (!(std::abs(got[c] - right[c]) <= allowed))
                        return fmt::format(
                            "{} gave ({:.4f}, {:.4f}, {:.4f}, {:.4f}), expected ({:.4f}, {:.4f}, {:.4f}, "
                            "{:.4f}){}",
                            what, got.x, got.y, got.z, got.w, right.x, right.y, right.z, right.w,
                            kind == 2   ? ": one entry alone is not 0, and the step passes it"
                            : kind == 4 ? ": what is near hides what is far"
                                        : "");
                return "";
            });
            if (check.failed) return;
        }
    }
    // Of the table that the specification names one part in 256.
    std::vector<glm::vec4> transfer;
    for (int i = 0; i < 256; ++i) transfer.push_back(glm::vec4(1, 0.5, 0.25, 0.4f * float(i % 2)));
    check.expect_quick(
        "preintegrate, of 256 pairs of a function of 256 entries,", "a table of 256 x 256", 256, 20,
        [&] {
            for (int i = 0; i < 256; ++i) preintegrate(transfer, float(i / 16) / 15.0f, float(i % 16) / 15.0f, 1.0f);
        },
        "one piece where front and back are equal; else a number of layers that grows with the entries passed "
        "and with the ratio, and no faster");
}

CHECK_EXERCISE("16.source_term",
               "what is not absorbed is scattered: a share of the sky, and of the light by the phase") {
    const auto right = [](auto in, double cosine, double sky_share) {
        Row out;
        const double g = in[18],
                     phase = (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        for (size_t c = 0; c < 3; ++c)
            out.push_back((1 - in[c]) * in[3 + c] +
                          in[c] * (sky_share * in[6 + c] + in[9 + c] * std::exp(-in[19]) * phase));
        return out;
    };
    const auto cosine = [](auto in) { return in[12] * in[15] + in[13] * in[16] + in[14] * in[17]; };
    Probe probe{.include = "16_volume/source_term.glsl",
                .signature =
                    "vec3 source_term(vec3 albedo, vec3 emitted, vec3 sky, vec3 irradiance, vec3 to_light, vec3 "
                    "along, float g, float depth)",
                .truth = [&](auto in) { return right(in, cosine(in), 1); },
                .bound = {.absolute = 1e-4, .relative = 1e-4},
                .hint = [&](auto in, auto out) -> std::string {
                    const auto is = [&](const Row& row) {
                        return std::fabs(out[0] - row[0]) < 1e-3 * (1 + std::fabs(row[0])) &&
                               std::fabs(out[1] - row[1]) < 1e-3 * (1 + std::fabs(row[1]));
                    };
                    if (std::fabs(in[18] * cosine(in)) > 0.05 && is(right(in, -cosine(in), 1)))
                        return "light comes along -to_light and leaves along -along: the light is turned by the angle "
                               "between these two";
                    if (in[6] > 0.1 && !is(right(in, cosine(in), 1)) && in[9] == 0)
                        return "the sky's radiance is the same in all directions, and the integral of the phase "
                               "function is 1";
                    return "";
                }};
    const auto put = [](Row& row, const glm::dvec3& v) { row.insert(row.end(), {v.x, v.y, v.z}); };
    Random random(8);
    const auto direction = [&] {
        const double z = random.uniform(-1, 1), around = random.uniform(0, 2 * std::numbers::pi);
        return glm::dvec3(std::sqrt(1 - z * z) * std::cos(around), std::sqrt(1 - z * z) * std::sin(around), z);
    };
    const auto color = [&](double most) {
        return glm::dvec3(random.uniform(0, most), random.uniform(0, most), random.uniform(0, most));
    };
    for (int i = 0; i < 300; ++i) {
        Row row;
        put(row, color(1));
        put(row, i % 3 ? glm::dvec3(0) : color(2));
        put(row, i % 3 == 1 ? glm::dvec3(0.2) + color(2) : glm::dvec3(0));
        put(row, i % 3 == 2 ? color(9) : i % 3 == 1 ? glm::dvec3(0) : color(2));
        put(row, direction());
        put(row, direction());
        row.push_back(random.uniform(-0.8, 0.9));
        row.push_back(i % 2 ? random.uniform(0, 6) : 0.0);
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
