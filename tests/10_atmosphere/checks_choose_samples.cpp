// What ./course check runs for 10.choose_samples: three paths, summed up as the choice says.
#include <cmath>

#include "common/check/choice.h"

using namespace lightwalk;

namespace {

struct Line {
    double height_m, slope, length_m;
};

// Of molecules, relative to sea level.
double density(const Line& line, double t) {
    constexpr double radius = 6360e3;
    const double from = radius + line.height_m;
    return std::exp(-(std::sqrt(from * from + t * t + 2 * from * line.slope * t) - radius) / 8000);
}

double summed(const Line& line, int method, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double power = method == 3 ? 2 : 1;
        const double a = line.length_m * std::pow(double(i) / n, power);
        const double b = line.length_m * std::pow((i + 1.0) / n, power);
        sum += (b - a) * (method == 2 ? (density(line, a) + density(line, b)) / 2 : density(line, (a + b) / 2));
    }
    return sum;
}

ChoiceScene scene(const std::string& name, const Line& line, double most_error, double most_cost) {
    return {name, most_error, most_cost, [line](std::span<const int> knobs) -> ErrorAndCost {
                const int method = knobs[0], n = knobs[1];
                const double exact = summed(line, 1, 100000);
                return {.error = 100 * std::abs(summed(line, method, n) / exact - 1), .cost = n + double(method == 2)};
            }};
}

}  // namespace

CHECK_EXERCISE("10.choose_samples", "Where on its way does a path meet most of its air?") {
    const double start = 6360e3 + 20e3, lowest = 6360e3 + 5e3, half_m = std::sqrt(start * start - lowest * lowest);
    check_choice(check, {.include = "10_atmosphere/choose_samples.glsl",
                         .signature = "ivec2 choose_samples(int path)",
                         .knobs = {{"the method", 1, 3}, {"n", 1, 64}},
                         .error_unit = "%",
                         .cost_unit = "densities",
                         .scenes = {scene("the path straight up", {0, 1, 100e3}, 1, 16),
                                    scene("the path past 5 km", {20e3, -half_m / start, 2 * half_m}, 1.25, 4),
                                    scene("the path of 20 km", {0, 0.05, 20e3}, 0.1, 1)}});
}
