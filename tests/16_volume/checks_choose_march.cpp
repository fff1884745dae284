// What ./course check runs for 16.choose_march: light and opacity along a ray, and its reads.
#include <cmath>

#include "common/check/choice.h"

using namespace lightwalk;

namespace {

constexpr int rays = 8;

struct Matter {
    double extinction, color;
};

struct Passed {
    double light = 0, through = 1;
    void add(const Matter& matter, double length_m) {
        const double opacity = 1 - std::exp(-matter.extinction * length_m);
        light += through * opacity * matter.color;
        through *= 1 - opacity;
    }
};

double density(int volume, double t) {
    if (volume == 0) return 0.5 + 0.3 * std::sin(2 * 3.14159265358979323846 * t);
    if (volume == 1) return std::max(1 - 2.2 * std::abs(t - 0.43), 0.0);
    return std::clamp(4 * (t - 0.2), 0.0, 1.0);
}

Matter matter(int volume, double d) {
    if (volume == 0) return {6 * d * d, d};
    if (volume == 1) return {60 * std::exp(-std::pow((d - 0.6) / 0.03, 2)), d};
    const double s = std::clamp((d - 0.5) / 0.4, 0.0, 1.0);
    return {40 * s * s * (3 - 2 * s), 0.2 + 0.8 * d};
}

Passed marched(int volume, int method, int n, double first) {
    Passed passed;
    for (int i = 0; i < n; ++i) {
        const auto at = [&](double step) { return density(volume, first + step / n); };
        const double before = at(i), after = at(i + 1.0);
        if (method == 1) passed.add(matter(volume, at(i + 0.5)), 1.0 / n);
        if (method == 2) {
            const Matter a = matter(volume, before), b = matter(volume, after);
            const double sum = a.extinction + b.extinction;
            if (sum > 0) passed.add({sum / 2, (a.extinction * a.color + b.extinction * b.color) / sum}, 1.0 / n);
        }
        if (method == 3)
            for (int k = 0; k < 256; ++k)
                passed.add(matter(volume, before + (after - before) * (k + 0.5) / 256), 1.0 / (256.0 * n));
    }
    return passed;
}

ChoiceScene scene(const std::string& name, int volume, double most_error, double most_reads) {
    return {name, most_error, most_reads, [volume](std::span<const int> knobs) -> ErrorAndCost {
                const int method = knobs[0], n = knobs[1];
                double error = 0;
                for (int k = 0; k < rays; ++k) {  // one ray alone may hit each corner of the density by luck
                    const Passed exact = marched(volume, 1, 20000, 0.01 * k),
                                 got = marched(volume, method, n, 0.01 * k);
                    error += std::max(std::abs(got.light - exact.light), std::abs(got.through - exact.through)) / rays;
                }
                return {.error = 100 * error, .cost = 2.0 * n + (method == 2 ? 2 : method == 3 ? 1 : 0)};
            }};
}

}  // namespace

CHECK_EXERCISE(
    "16.choose_march",
    "Between two reads, is it the density that changes quickly, or what the transfer function makes of it?") {
    check_choice(check,
                 {.include = "16_volume/choose_march.glsl",
                  .signature = "ivec2 choose_march(int volume)",
                  .knobs = {{"the method", 1, 3}, {"n", 1, 128}},
                  .error_unit = "%",
                  .cost_unit = "reads",
                  .scenes = {scene("the fog", 0, 1.5, 8), scene("the skin", 1, 1, 16), scene("the bone", 2, 0.3, 34)}});
}
