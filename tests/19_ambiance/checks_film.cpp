// Checks of chapter 19's fade, and of resources prepared before a cut.
#include <fmt/core.h>

#include <cmath>

#include "19_ambiance/exercises.h"
#include "19_ambiance/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("19.fade_linear_light",
               "fade linear light, not codes, and clamp nothing at 1: a sun would lose its colour") {
    Random random(2);
    Probe probe{.include = "19_ambiance/fade_linear_light.glsl",
                .signature = "vec3 fade_linear_light(vec3 light, float black, float white)",
                .bound = {.absolute = 1e-6, .relative = 1e-5}};
    // Each fade alone, and with values outside of its range; the lamp's channels lie below 16, the sun's above.
    for (const double level : {1.0, 1000.0})
        for (const auto& [black, white] : {std::pair(0.5, 0.0), {0.0, 0.5}, {0.5, 0.5}, {-0.5, 0.0}, {0.0, 1.5}})
            probe.inputs.push_back({level, 0.5 * level, 0.25 * level, black, white});
    for (int i = 0; i < 240; ++i) {
        const double level = i % 5 == 0 ? 0.0 : random.logarithmic(1e-3, 1e4);
        const glm::dvec3 light = level * glm::dvec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        const double black = i % 4 == 0 ? 0 : i % 11 == 0 ? 1 : i % 13 == 0 ? 1.5 : random.uniform(0, 1);
        const double white = i % 3 == 0 ? 0 : i % 7 == 0 ? 1 : i % 17 == 0 ? -0.5 : random.uniform(0, 1);
        probe.inputs.push_back({double(float(light.x)), double(float(light.y)), double(float(light.z)), black, white});
    }
    probe.truth = [](std::span<const double> in) {
        const glm::dvec3 faded = truth::fade_linear_light({in[0], in[1], in[2]}, in[3], in[4]);
        return Row{faded.x, faded.y, faded.z};
    };
    probe.hint = [](auto in, auto) -> std::string {
        if (in[3] > 0 && in[4] <= 0) return "to black: one factor for all channels, (1 - black) to the power of 2.2";
        return in[3] <= 0
                   ? "to white: a channel below 16 goes towards 16, one above it stays"
                   : "first to black, then to white from there; a channel that is above 16 after the first stays";
    };
    const Table results = check.probe(probe);
    check.property(probe, results, "but black 1 is exactly 0 where there is no white", [](auto in, auto out) {
        return in[3] < 1 || in[4] > 0 || (out[0] == 0 && out[1] == 0 && out[2] == 0);
    });
}

namespace {

std::string listed(const std::vector<int>& numbers) {
    std::string all;
    for (const int number : numbers) all += (all.empty() ? "" : ", ") + std::to_string(number);
    return all.empty() ? "none" : all;
}

}  // namespace

CHECK_EXERCISE("19.warm", "those on the screen whatever happens; then, by the time at which they begin, what fits") {
    struct Case {
        std::vector<OnScreen> scenes;
        double now = 0, ahead = 0;
        int most = 1;
    };
    const std::vector<OnScreen> four{{0, 5}, {5, 9}, {9, 12}, {12, 20}};
    std::vector<Case> cases{{four, 2, 0, 1},
                            {four, 5, 0, 1},
                            {four, 2, 3, 2},
                            {four, 2, 20, 2},
                            {{{9, 12}, {5, 9}, {0, 5}}, 2, 20, 3},
                            {{{1, 9}, {0, 8}, {2, 9}}, 4, 20, 1}};
    Random random(4);
    for (int i = 0; i < 340; ++i) {
        Case one;
        // Fades and split pictures: several begin at once. A short list's order survives a sort that keeps none.
        const int count = i < 300 ? i % 9 : i - 290;
        for (int k = 0; k < count; ++k) {
            const double from = std::floor(random.uniform(0, i < 300 ? 40 : 6)) / 2;
            one.scenes.push_back({from, from + 0.5 + std::floor(random.uniform(0, 12)) / 2});
        }
        one.now = i % 3 ? std::floor(random.uniform(0, i < 300 ? 44 : 8)) / 2 : random.uniform(0, 22);
        one.ahead = i % 5 ? std::floor(random.uniform(0, 20)) / 2 : 0;
        one.most = i < 300 ? 1 + i % 4 : 30;
        cases.push_back(one);
    }
    for (const auto& [scenes, now, ahead, most] : cases) {
        std::string what = "warm({";
        for (const OnScreen& one : scenes) what += fmt::format(" {:g}-{:g}", one.from_s, one.to_s);
        what += fmt::format(" }}, now {:g} s, {:g} s ahead, at most {})", now, ahead, most);
        check.call(what, [&]() -> std::string {
            const std::vector<int> got = warm(scenes, now, ahead, most), right = truth::warm(scenes, now, ahead, most);
            if (got == right) return "";
            return fmt::format("{} gave {}, expected {}", what, listed(got), listed(right));
        });
        if (check.failed) return;
    }
}
