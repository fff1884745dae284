// Checks of 15.wave_amplitude: variances of parts of the sea, against integrals of the spectrum over frequencies.
#include <fmt/core.h>

#include <cmath>
#include <functional>

#include "15_terrain_water/exercises.h"
#include "15_terrain_water/ocean.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

/// A part of the plane of wave vectors: lengths from `from` to `to` in 1/m, angles to the wind in radians.
struct Part {
    std::string name;
    double from, to, left, right;
    std::function<double(double omega)> density;
};

double omega_of(double k) { return std::sqrt(9.81 * k); }

/// The spectrum over the part's frequencies, times the directions' share: the integral of 2 / pi cos².
double expected(const Part& part) {
    const double low = omega_of(part.from), high = omega_of(part.to);
    double sum = 0;
    for (int i = 0; i < 4000; ++i) sum += part.density(low + (high - low) * (i + 0.5) / 4000) * (high - low) / 4000;
    const auto up_to = [](double angle) { return (angle + std::sin(angle) * std::cos(angle)) / M_PI; };
    return sum * (up_to(part.right) - up_to(part.left));
}

/// The variance of the part's waves, by midpoints in polar coordinates: each wave stands for step² of the plane.
double variance(const Part& part, double step) {
    constexpr int rings = 48, sectors = 12;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double ratio = part.to / part.from, k = part.from * std::pow(ratio, (i + 0.5) / rings);
            const double width = part.from * (std::pow(ratio, (i + 1.0) / rings) - std::pow(ratio, double(i) / rings));
            const double angle = part.left + (part.right - part.left) * (j + 0.5) / sectors;
            const double area = k * width * (part.right - part.left) / sectors;
            const double a = wave_amplitude(part.density(omega_of(k)), k, std::cos(angle), step);
            sum += 4 * a * a * area / (step * step);
        }
    return sum;
}

}  // namespace

CHECK_EXERCISE(
    "15.wave_amplitude",
    "The density over the plane of k is density * 2/pi along² * dω/dk / k; four times a² is that times step².") {
    const auto none = [&](const std::string& name, double k, double along) {
        const std::string what = fmt::format("wave_amplitude(density 1, k {}, along {}, step 0.1)", k, along);
        check.call(what, [&]() -> std::string {
            const double got = wave_amplitude(1, k, along, 0.1);
            return got == 0 ? "" : fmt::format("{} gave {:.6g} for {}, expected 0", what, got, name);
        });
    };
    none("a wave against the wind", 1, -0.5);
    none("a wave straight against the wind", 0.2, -1);
    none("a wave across the wind", 3, 0);
    none("a wave vector of length 0", 0, 1);

    const auto even = [](double) { return 1.0; };
    const auto sea = [](double omega) { return jonswap(omega, 8, 60e3); };
    const Part parts[] = {
        {"density 1 from 0.1 to 0.2 per metre, along the wind", 0.1, 0.2, -0.2, 0.2, even},
        {"density 1 from 3 to 6 per metre, along the wind", 3, 6, -0.2, 0.2, even},
        {"density 1 from 0.1 to 0.2 per metre, 60 to 70 degrees beside the wind", 0.1, 0.2, 1.047, 1.222, even},
        {"density 1 from 0.1 to 10 per metre, all directions", 0.1, 10, -M_PI / 2, M_PI / 2, even},
        {"a wind of 8 m/s over 60 km, all waves", 0.03, 60, -M_PI / 2, M_PI / 2, sea}};
    for (const Part& part : parts)
        for (const double step : {0.02, 0.3}) {
            const std::string what = fmt::format("wave_amplitude(), {}, step {}", part.name, step);
            check.call(what, [&]() -> std::string {
                const double got = variance(part, step), right = expected(part), times = got / right;
                if (std::fabs(times - 1) < 0.01) return "";
                const std::string words = fmt::format(
                    "{}: the waves have a variance of {:.4g} m², the spectrum's integral "
                    "is {:.4g} m²",
                    what, got, right);
                for (const auto& [factor, name] : {std::pair(2.0, "twice"), std::pair(4.0, "four times"),
                                                   std::pair(0.5, "half"), std::pair(0.25, "a quarter of")})
                    if (std::fabs(times / factor - 1) < 0.02) return fmt::format("{}: {} as much", words, name);
                return words;
            });
            if (check.failed) return;
        }
}
