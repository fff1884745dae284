// What ./course check runs for the test of a cone against a ball.
#include <cmath>
#include <numbers>

#include "03_attenuation/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

double gap(std::span<const double> in) {
    const glm::dvec3 center(in[0], in[1], in[2]), axis(in[4], in[5], in[6]);
    return truth::distance_to_cone(center, glm::dvec3(0), glm::normalize(axis), std::acos(in[7])) - in[3];
}

}  // namespace

CHECK_EXERCISE("03.cone_reaches_ball",
               "Which point of the cone is nearest to the ball: one on its side, or its apex?") {
    constexpr double narrow = 0.86602540378443865;  // 30 degrees
    Probe probe{.include = "03_attenuation/cone_reaches_ball.glsl",
                .signature = "bool cone_reaches_ball(vec3 center, float radius, vec3 axis, float cos_outer)",
                .inputs = {{0, 0, 4, 0.5, 0, 0, 1, narrow},
                           {0, 3, 4, 1, 0, 0, 1, narrow},
                           {0, 3, 4, 0.5, 0, 0, 1, narrow},
                           {0, 0, -4, 3, 0, 0, 1, narrow},
                           {0, 0, -4, 5, 0, 0, 1, narrow},
                           {0, 1, -4, 3, 0, 0, 1, narrow},
                           {0, 8, 4, 0.5, 0, 0, 1, 0.5},
                           {0, 5, 4, 1, 0, 0, 1, 0.7},
                           {0, 1, -4, 0.5, 0, 0, 1, -0.5},
                           {0, 1, -4, 3.5, 0, 0, 1, -0.5}},
                .truth = [](std::span<const double> in) { return Row{double(gap(in) <= 0)}; },
                .grants =
                    [](std::span<const double> in, std::span<const double> got) {
                        const double away = glm::length(glm::dvec3(in[0], in[1], in[2]));
                        return (got[0] == 0 || got[0] == 1) && std::abs(gap(in)) < 1e-3 * away;
                    },
                .hint = [](auto in, auto got) -> std::string {
                    const double along = in[0] * in[4] + in[1] * in[5] + in[2] * in[6];
                    if (got[0] == 0)
                        return "The ball's middle is beside the cone here, and a part of the ball reaches it.";
                    if (along < 0 && in[7] > 0) return "The cone does not go on behind the apex.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 600; ++i) {
        const glm::vec3 center = static_cast<float>(random.logarithmic(0.1, 30)) * random.direction();
        const glm::vec3 axis = i % 7 ? random.direction() : glm::normalize(center) * (i % 2 ? 1.0f : -1.0f);
        Row row;
        append(row, center);
        row.push_back(random.logarithmic(0.01, 10));
        append(row, axis);
        row.push_back(static_cast<float>(std::cos(random.uniform(0, i % 5 ? 1.5 : 3.1))));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
