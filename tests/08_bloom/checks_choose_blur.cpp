// What ./course check runs for 08.choose_blur: the profile of a blurred point, and its reads.
#include <cmath>

#include "common/check/choice.h"

using namespace lightwalk;

namespace {

constexpr int length = 1024, middle = 512;

std::vector<double> gaussian(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += weights.emplace_back(std::exp(-i * i / (2 * sigma * sigma)));
    for (double& weight : weights) weight /= sum;
    return weights;
}

std::vector<double> blurred(const std::vector<double>& line, const std::vector<double>& weights) {
    std::vector<double> out(line.size());
    const int radius = int(weights.size() / 2), size = int(line.size());
    for (int i = 0; i < size; ++i)
        for (int k = -radius; k <= radius; ++k)
            if (i + k >= 0 && i + k < size) out[size_t(i)] += weights[size_t(k + radius)] * line[size_t(i + k)];
    return out;
}

/// Blurs in a quarter of the width: means of four, and linear interpolation back.
std::vector<double> blurred_small(const std::vector<double>& line, double sigma, int radius) {
    std::vector<double> small(length / 4);
    for (size_t i = 0; i < length; ++i) small[i / 4] += line[i] / 4;
    small = blurred(small, gaussian(sigma / 4, radius / 4));
    std::vector<double> out(length);
    for (int i = 0; i < length; ++i) {
        const double at = std::clamp((i + 0.5) / 4 - 0.5, 0.0, length / 4 - 1.001);
        const auto below = size_t(at);
        out[size_t(i)] = small[below] + (at - double(below)) * (small[below + 1] - small[below]);
    }
    return out;
}

/// Of a point at each of the four places within a small texel, in percent of the peak.
double error(double sigma, int method, int radius) {
    double worst = 0;
    const std::vector<double> exact = gaussian(sigma, middle - 8);
    for (int at = middle; at < middle + 4; ++at) {
        std::vector<double> line(length);
        line[size_t(at)] = 1;
        const std::vector<double> found =
            method == 4 ? blurred_small(line, sigma, radius) : blurred(line, gaussian(sigma, radius));
        for (int i = at - 400; i <= at + 400; ++i)
            worst = std::max(worst, std::abs(found[size_t(i)] - exact[size_t(i - at + middle - 8)]));
    }
    return 100 * worst / exact[middle - 8];
}

double reads(int method, int radius) {
    if (method == 1) return (2.0 * radius + 1) * (2 * radius + 1);
    if (method == 2) return 2.0 * (2 * radius + 1);
    if (method == 3) return 2.0 * (radius + 1);
    return 2 + 2.0 * (2 * (radius / 4) + 1) / 16;
}

ChoiceScene blur(double sigma, double most_error, double most_reads) {
    return {"the blur of sigma " + number_text(sigma), most_error, most_reads,
            [sigma](std::span<const int> knobs) -> ErrorAndCost {
                const int method = knobs[0], radius = knobs[1];
                return {.error = error(sigma, method, radius), .cost = reads(method, radius)};
            }};
}

}  // namespace

CHECK_EXERCISE("08.choose_blur",
               "How many sigmas away does a weight no longer count, and how few texels does it then take?") {
    check_choice(check, {.include = "08_bloom/choose_blur.glsl",
                         .signature = "ivec2 choose_blur(int blur)",
                         .knobs = {{"the method", 1, 4}, {"the radius", 0, 256}},
                         .error_unit = "%",
                         .cost_unit = "reads",
                         .scenes = {blur(2, 0.5, 16), blur(12, 1, 80), blur(48, 2.5, 12)}});
}
