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

CHECK_EXERCISE("13.keep_or_reject", "Outside, or behind something: even the farthest of the nine was nearer.") {
    Probe probe{.include = "13_mlaa/keep_or_reject.glsl",
                .signature = "bool keep_history(vec2 at, vec2 size, float expected, float farthest)",
                .inputs = {{0, 0, 80, 60, 0.5, 0.5},
                           {79.9, 59.9, 80, 60, 0.5, 0.5},
                           {80, 30, 80, 60, 0.5, 0.5},
                           {40, 60, 80, 60, 0.5, 0.5},
                           {-0.1, 30, 80, 60, 0.5, 0.5},
                           {40, -0.1, 80, 60, 0.5, 0.5},
                           {40, 30, 80, 60, 0, 0},
                           {40, 30, 80, 60, 0, 0.1},
                           {40, 30, 80, 60, 0, 5e-7},
                           {40, 30, 80, 60, 0, 2e-6},
                           {40, 30, 80, 60, 0.5, 0},
                           {40, 30, 80, 60, 0.5, 0.52},
                           {40, 30, 80, 60, 0.5, 0.53},
                           {40, 30, 80, 60, 0.5, 0.5256},  // 5.1% of what was expected, 4.9% of what was found
                           {40, 30, 80, 60, 4, 4.204},
                           {40, 30, 80, 60, 1, 0.1}},
                .truth =
                    [](std::span<const double> in) {
                        const bool inside = in[0] >= 0 && in[1] >= 0 && in[0] < in[2] && in[1] < in[3];
                        return Row{double(inside && in[5] <= 1.05 * in[4] + 1e-6)};
                    },
                .hint = [](auto in, auto got) -> std::string {
                    if (in[0] < 0 || in[1] < 0 || in[0] >= in[2] || in[1] >= in[3])
                        return "There is no history outside of the picture.";
                    if (in[5] < in[4] && got[0] == 0)
                        return "The nine samples were farther: they may have missed a thin object. Keep the history.";
                    if (in[5] > in[4]) return "A larger inverse distance is nearer.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) {
        const double expected = random.logarithmic(1e-3, 10), factor = random.uniform(0.9, 1.2);
        if (std::abs(factor - 1.05) < 1e-3) continue;
        probe.inputs.push_back(
            {random.uniform(-20, 100), random.uniform(-20, 80), 80, 60, expected, expected * factor});
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
                .inputs = {Row(9, 0.25), Row(9, 0.0)},
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
