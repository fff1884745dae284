// What ./course check runs for 04.choose_relief: hits on three height maps, and their reads.
#include <cmath>

#include "common/check/choice.h"

using namespace lightwalk;

namespace {

double depth_at(int surface, double u) {
    constexpr double pi = 3.14159265358979323846;
    u -= std::floor(u);
    if (surface == 0) return (1 + std::cos(2 * pi * u)) / 2;
    if (surface == 1) return u > 0.25 && u < 0.75 ? 0 : 1;
    return std::abs(std::fmod(4 * u, 2) - 1);
}

struct Ray {
    int surface;
    double from, aside;
    double above(double t) const { return depth_at(surface, from + aside * t) - t; }  ///< the surface, below 0: passed
};

/// The depth of the hit.
double hit(const Ray& ray, int method, int layers) {
    if (method == 1) return ray.above(0);
    int i = 0;
    while (i < layers && ray.above(double(i) / layers) > 0) ++i;
    double after = double(i) / layers, before = double(i - 1) / layers;
    if (i == 0 || method == 2) return after;
    if (method == 3) {
        const double a = ray.above(before), b = ray.above(after);
        return a > b ? before + (after - before) * a / (a - b) : after;
    }
    for (int half = 0; half < 5; ++half) {
        const double middle = (before + after) / 2;
        (ray.above(middle) > 0 ? before : after) = middle;
    }
    return after;
}

ChoiceScene scene(const std::string& name, int surface, double aside, double most_error, double most_reads) {
    return {name, most_error, most_reads, [=](std::span<const int> knobs) -> ErrorAndCost {
                const int method = knobs[0], layers = knobs[1];
                double sum = 0;
                for (int i = 0; i < 128; ++i) {
                    const Ray ray{surface, (i + 0.5) / 128, aside};
                    sum += std::abs(hit(ray, method, layers) - hit(ray, 2, 20000));
                }
                return {.error = 100 * sum / 128, .cost = method == 1 ? 1.0 : layers + (method == 4 ? 6.0 : 1.0)};
            }};
}

}  // namespace

CHECK_EXERCISE("04.choose_relief", "Is the surface straight between two layers, and where does it jump?") {
    check_choice(check, {.include = "04_surface_maps/choose_relief.glsl",
                         .signature = "ivec2 choose_relief(int surface)",
                         .knobs = {{"the method", 1, 4}, {"n", 1, 64}},
                         .error_unit = "%",
                         .cost_unit = "reads",
                         .scenes = {scene("the ripples", 0, 0.02, 0.5, 2), scene("the grooves", 1, 0.3, 0.1, 24),
                                    scene("the ramps", 2, 0.15, 0.05, 16)}});
}
