// Checks of the functions of temporal anti-aliasing.
#include <fmt/core.h>

#include <glm/gtc/matrix_transform.hpp>

#include "13_mlaa/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("13.reproject", "Pixels to -1 to 1, the matrix, the division by w, and back to pixels.") {
    Probe probe{.include = "13_mlaa/reproject.glsl",
                .signature = "vec3 reproject(vec2 at, float depth, vec2 size, mat4 to_before)",
                .inputs = {},
                .truth =
                    [](std::span<const double> in) {
                        glm::dmat4 to_before;
                        for (int i = 0; i < 16; ++i) to_before[i / 4][i % 4] = in[size_t(5 + i)];
                        const glm::dvec3 then = truth::reprojected({in[0], in[1]}, in[2], {in[3], in[4]}, to_before);
                        return Row{then.x, then.y, then.z};
                    },
                .bound = {.absolute = 0.02, .relative = 1e-4},
                .hint = [](auto in, auto got) -> std::string {
                    if (std::abs(got[2]) > 0 && std::abs(got[0] - in[0]) < 1e-4 && std::abs(got[1] - in[1]) < 1e-4)
                        return "The camera has moved: the surface was elsewhere.";
                    return "";
                }};
    // A surface beside the camera, where w is exactly 0; then one right before it, and one right behind it.
    probe.inputs.push_back({50, 40, 0.3, 200, 300, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    probe.inputs.push_back({100, 150, 0.3, 200, 300, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    for (const double w : {0.004, -0.004})
        probe.inputs.push_back({50, 40, 0.3, 200, 300, w, 0, 0, 0, 0, w, 0, 0, 0, 0, w, 0, 0, 0, 0, w});
    Random random;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec2 size = i % 3 ? glm::dvec2(640, 360) : glm::dvec2(200, 300);
        // A camera with reversed depth and no far plane (T. Lottes and N. Reed, 2015) that moves, turns, or both.
        glm::dmat4 projection(0.0);
        projection[0][0] = 1.2 * size.y / size.x;
        projection[1][1] = -1.2;
        projection[2][3] = -1;
        projection[3][2] = 0.1;
        const double reach = i % 5 == 4 ? 3.0 : 0.2;
        glm::dmat4 moved = glm::translate(glm::dmat4(1), {random.uniform(-reach, reach), random.uniform(-reach, reach),
                                                          random.uniform(-reach, reach)});
        moved = glm::rotate(moved, random.uniform(-0.2, 0.2), {0.0, 1.0, 0.0});
        const glm::dmat4 to_before = i == 0 ? glm::dmat4(1) : projection * moved * glm::inverse(projection);
        Row row{random.uniform(0, size.x), random.uniform(0, size.y),
                i % 7 == 0 ? 0.0 : 0.1 / random.logarithmic(0.3, 300), size.x, size.y};
        for (int k = 0; k < 16; ++k) row.push_back(to_before[k / 4][k % 4]);
        const glm::dvec4 clip = to_before * glm::dvec4(2.0 * glm::dvec2(row[0], row[1]) / size - 1.0, row[2], 1.0);
        if (std::abs(clip.w) > 0.05) probe.inputs.push_back(row);  // nearer to 0 a float decides otherwise
    }
    check.probe(probe);
}

CHECK_EXERCISE("13.accumulate",
               "a mean of n samples and one more: n counts of the old, one of the new, over their sum") {
    const double infinite = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();
    // By the weight of the new sample, of each one of the history, and the number of these.
    const auto mean = [](std::span<const double> in, double fresh, double old, double count) {
        Row row;
        for (size_t c = 0; c < 3; ++c)
            row.push_back(count > 0 ? (fresh * in[c] + count * old * in[c + 3]) / (fresh + count * old) : in[c]);
        row.push_back(count + 1);
        return row;
    };
    const auto count_of = [](std::span<const double> in) { return std::min(in[6], std::max(in[7] - 1, 0.0)); };
    const auto right = [=](std::span<const double> in) {
        const bool tone = in[8] != 0;
        return mean(in, tone ? 1 / (1 + in[0]) : 1, tone ? 1 / (1 + in[3]) : 1, count_of(in));
    };
    Probe probe{
        .include = "13_mlaa/accumulate.glsl",
        .signature = "vec4 accumulate(vec3 fresh, vec3 history, float samples, float most, bool tone)",
        .truth = right,
        .bound = {.absolute = 1e-5, .relative = 1e-5},
        .hint = [=](std::span<const double> in, std::span<const double> got) -> std::string {
            const auto is = [&](const Row& other) {
                for (size_t c = 0; c < 4; ++c)
                    if (!(std::fabs(got[c] - other[c]) <= 1e-5 + 1e-5 * std::fabs(other[c]))) return false;
                return true;
            };
            const double count = count_of(in);
            if (in[6] == 0)
                return "without a history the result is the new light, worth one sample; 0 times NaN is NaN";
            if (in[7] <= 1) return "the result is worth one sample: the new one";
            if (std::fabs(got[3] - count) < 1e-4) return "the new sample counts, too, in what the result is worth";
            if (in[6] + 1 > in[7] && std::fabs(got[3] - in[7] - 1) < 1e-4)
                return "`most` is the worth of the result, which has the new sample in it";
            if (in[6] + 1 > in[7] && got[3] > in[7] + 1e-4) return "the result is worth `most` samples at most";
            const double fresh = 1 / (1 + in[0]), old = 1 / (1 + in[3]);
            if (in[8] != 0 && is(mean(in, 1, 1, count))) return "with `tone`, samples count by 1 / (1 + Y)";
            if (in[8] != 0 &&
                (is(mean(in, fresh, 1, count)) || is(mean(in, 1, old, count)) || is(mean(in, fresh, fresh, count))))
                return "with `tone`, the new sample counts by its own Y, and those of the history by the history's";
            return "";
        }};
    const auto add = [&](glm::dvec3 fresh, glm::dvec3 history, double samples, double most, bool tone) {
        Row row;
        append(row, fresh);
        append(row, history);
        row.insert(row.end(), {samples, most, double(tone)});
        probe.inputs.push_back(row);
    };
    const glm::dvec3 one(1, 0.25, -0.125), two(3, -0.5, 0.25);
    for (const bool tone : {false, true}) {
        for (const double samples : {0.0, 1.0, 3.0, 4.0, 31.0, 1023.0})
            for (const double most : {0.0, 0.5, 1.0, 1.5, 4.0, 5.0, 1024.0}) add(one, two, samples, most, tone);
        for (const double old : {infinite, -infinite, not_a_number}) add(one, glm::dvec3(old), 0, 32, tone);
        add(glm::dvec3(0), two, 3, 32, tone);
        add(two, glm::dvec3(0), 3, 32, tone);
    }
    Random random;
    const auto light = [&] {
        return glm::dvec3(random.logarithmic(1e-3, 100), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 fresh = light();
        add(fresh, light(), std::floor(random.logarithmic(1, 1000)), random.logarithmic(1, 300), i % 2);
    }
    check.probe(probe);
}

CHECK_EXERCISE("13.clip_history", "How much too far the history is, in the worst component, shortens the whole line.") {
    Probe probe{
        .include = "13_mlaa/clip_history.glsl",
        .signature = "vec3 clip_history(vec3 history, vec3 lowest, vec3 highest)",
        .inputs = {{0.5, 0, 0, 0, -1, -1, 1, 1, 1},
                   {3, 0, 0, 0, -1, -1, 1, 1, 1},
                   {0.5, 0, 0, 0.5, 0, 0, 0.5, 0, 0},
                   {0.9, 0.1, 0, 0.5, 0, 0, 0.5, 0, 0},
                   {0.9, 0, 0, 0.2, 0, 0, 0.5, 0, 0},
                   {0.5, 0.4, -0.3, 0, 0, 0, 1, 0, 0},
                   {2, 2, 2, 0, 0, 0, 1, 1, 1}},
        .truth =
            [](std::span<const double> in) {
                const glm::dvec3 found = truth::clipped(vector3(in), vector3(in.subspan(3)), vector3(in.subspan(6)));
                return Row{found.x, found.y, found.z};
            },
        .bound = {.absolute = 1e-5, .relative = 1e-5},
        .hint = [](auto in, auto got) -> std::string {
            bool clamped = true;
            for (size_t c = 0; c < 3; ++c)
                clamped = clamped && std::abs(got[c] - std::clamp(in[c], in[3 + c], in[6 + c])) < 1e-5;
            return clamped ? "Each component was clamped alone: that is the nearest point of the box, not the one "
                             "on the line to its middle."
                           : "";
        }};
    Random random;
    for (int i = 0; i < 600; ++i) {
        Row row(9);
        for (size_t c = 0; c < 3; ++c) {
            const double a = random.uniform(-0.5, 1), wide = (i + int(c)) % 6 ? random.uniform(0.01, 0.6) : 0.0;
            row[3 + c] = a;
            row[6 + c] = a + wide;
            row[c] = a + random.uniform(-0.6, 1.2);
        }
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("13.ghost", "Which of two depths is nearer? In this course depth is reversed.") {
    Probe probe{.include = "13_mlaa/ghost.glsl",
                .signature = "ivec2 nearest_of_nine(mat3 depths)",
                // The last has its nearest on the right and its farthest at the upper left: one cause for each mistake.
                .inputs = {Row(9, 0.25), Row(9, 0.0), {0.125, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.875, 0.5}},
                .truth =
                    [](std::span<const double> in) {
                        size_t best = 4;
                        for (size_t i = 0; i < 9; ++i)
                            if (in[i] > in[best]) best = i;
                        return Row{double(best / 3) - 1, double(best % 3) - 1};
                    },
                .grants =
                    [](std::span<const double> in, std::span<const double> got) {
                        const auto place = [](double step) { return std::abs(step) <= 1 ? size_t(step + 1) : 9; };
                        const size_t x = place(got[0]), y = place(got[1]);
                        const double most = *std::max_element(in.begin(), in.end());
                        return x < 3 && y < 3 && in[4] < most && in[3 * x + y] == most;
                    },
                .hint = [](auto in, auto got) -> std::string {
                    for (const double step : {got[0], got[1]})
                        if (step != std::round(step) || step < -1) return "";
                    if (got[0] > 1 || got[1] > 1) return "each step is -1, 0 or 1, not the index of a column or row";
                    const auto [least, most] = std::minmax_element(in.begin(), in.end());
                    if (in[4] == *most) return "no other depth is greater than the pixel's own: the step is (0, 0)";
                    const size_t x = size_t(got[0] + 1), y = size_t(got[1] + 1);
                    if (in[3 * x + y] == *least) return "that is the farthest: depth is 1 near, and 0 at infinity";
                    if (in[3 * y + x] == *most) return "x and y are exchanged: depths[x + 1][y + 1]";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 300; ++i) {
        Row row;
        for (int k = 0; k < 9; ++k)
            row.push_back(i % 4 == 3 ? 0.125 * int(random.uniform(0, 4)) : random.uniform(0, 1));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
