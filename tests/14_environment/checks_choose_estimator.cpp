// What ./course check runs for 14.choose_estimator: estimates of three integrals, and their directions.
#include <cmath>

#include "common/check/choice.h"

using namespace lightwalk;

namespace {

const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.48, 0.6, 0.64));
const double sun_cosine = std::cos(0.06);

struct Surface {
    double alpha;
    bool polished, sunny;
    /// Without the sun's disc.
    double sky(const glm::dvec3& d) const { return sunny ? 0.2 : 0.3 + 0.7 * (0.5 + 0.5 * d.y) + 0.4 * d.x; }
    double light(const glm::dvec3& d) const { return sky(d) + (sunny && glm::dot(d, to_sun) > sun_cosine ? 200 : 0); }
    double lobe(double half_cosine) const {
        const double a2 = alpha * alpha, c = half_cosine * half_cosine * (a2 - 1) + 1;
        return a2 / (M_PI * c * c);
    }
    /// Its share of light from there, with the cosine.
    double reflects(const glm::dvec3& d) const {
        if (d.y <= 0) return 0;
        return polished ? lobe(std::sqrt((1 + d.y) / 2)) * d.y / 4 : d.y / M_PI;
    }
};

double radical_inverse(unsigned i) {
    double sum = 0;
    for (double digit = 0.5; i; i >>= 1, digit /= 2) sum += digit * (i & 1);
    return sum;
}

glm::dvec3 around(double cosine, double turn) {
    const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    return {sine * std::cos(2 * M_PI * turn), cosine, sine * std::sin(2 * M_PI * turn)};
}

/// The mean over n directions of the method; with `sky` alone, of light without the sun.
double estimated(const Surface& surface, int method, int n, bool sky_alone = false) {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double u = (i + 0.5) / n, turn = radical_inverse(unsigned(i));
        const double half = std::sqrt((1 - u) / (1 + (surface.alpha * surface.alpha - 1) * u));
        const double cosine = method == 1 ? 1 - u : method == 2 ? std::sqrt(1 - u) : 2 * half * half - 1;
        const double density = method == 1 ? 1 / (2 * M_PI) : method == 2 ? cosine / M_PI : surface.lobe(half) / 4;
        const glm::dvec3 d = around(cosine, turn);
        sum += (sky_alone ? surface.sky(d) : surface.light(d)) * surface.reflects(d) / density;
    }
    return sum / n;
}

double from_sun(const Surface& surface, int n) {
    if (!surface.sunny) return 0;
    const glm::dvec3 side = glm::normalize(glm::cross(to_sun, glm::dvec3(0, 0, 1))), other = glm::cross(to_sun, side);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const glm::dvec3 d = around(1 - (i + 0.5) / n * (1 - sun_cosine), radical_inverse(unsigned(i)));
        sum += 200 * surface.reflects(d.x * side + d.y * to_sun + d.z * other) * 2 * M_PI * (1 - sun_cosine);
    }
    return sum / n;
}

double both(const Surface& surface, int n) { return from_sun(surface, n / 2) + estimated(surface, 2, n - n / 2, true); }

ChoiceScene scene(const std::string& name, const Surface& surface, double most_error, double most_directions) {
    return {name, most_error, most_directions, [surface](std::span<const int> knobs) -> ErrorAndCost {
                const int method = knobs[0], n = knobs[1];
                const double exact = surface.polished ? estimated(surface, 3, 100000) : both(surface, 200000);
                const double got = method == 4 ? both(surface, n) : estimated(surface, method, n);
                return {.error = 100 * std::abs(got / exact - 1), .cost = double(n)};
            }};
}

}  // namespace

CHECK_EXERCISE("14.choose_estimator",
               "What is large in the integrand: the light, the cosine, or the lobe? Put directions there.") {
    check_choice(check, {.include = "14_environment/choose_estimator.glsl",
                         .signature = "ivec2 choose_estimator(int surface)",
                         .knobs = {{"the method", 1, 4}, {"n", 2, 256}},
                         .error_unit = "%",
                         .cost_unit = "directions",
                         .scenes = {scene("the matt one under clouds", {1, false, false}, 0.4, 16),
                                    scene("the polished one", {0.04, true, false}, 1, 8),
                                    scene("the matt one in the sun", {1, false, true}, 1, 16)}});
}
