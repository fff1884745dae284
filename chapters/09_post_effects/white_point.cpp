#include <map>

#include "09_post_effects/aces_truth.h"
#include "09_post_effects/post.h"
#include "09_post_effects/tone_truth.h"

namespace lightwalk {
namespace {

// CIE 15: the daylight locus (D. B. Judd et al., 1964).
glm::dvec2 daylight(double kelvin) {
    const double t = 1e3 / kelvin;
    const double x = kelvin <= 7000 ? 0.244063 + 0.09911 * t + 2.9678 * t * t - 4.6070 * t * t * t
                                    : 0.237040 + 0.24748 * t + 1.9018 * t * t - 2.0064 * t * t * t;
    return {x, -3 * x * x + 2.87 * x - 0.275};
}

}  // namespace

glm::mat3 white_balance_matrix(double kelvin) {
    if (kelvin == 6504.0) return glm::mat3(1.0f);
    const glm::dmat3 rgb = truth::rec709_to_xyz();
    return glm::mat3(glm::inverse(rgb) * truth::bradford(daylight(kelvin), daylight(6504)) * rgb);
}

double matching_gain(const std::string& tone) {
    static const double wanted = truth::tone("aces", glm::dvec3(0.18)).g;
    static std::map<std::string, double> known;
    if (const auto it = known.find(tone); it != known.end()) return it->second;
    double low = 0.01, high = 100;  // every curve rises
    for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(low * high);
        (truth::tone(tone, glm::dvec3(0.18 * middle)).g < wanted ? low : high) = middle;
    }
    return known[tone] = tone == "aces" ? 1 : low;
}

}  // namespace lightwalk
