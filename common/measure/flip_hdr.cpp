// HDR-FLIP, and summaries of error maps.
#include <algorithm>
#include <array>
#include <cmath>

#include "common/base/error.h"
#include "common/base/statistics.h"
#include "common/measure/flip.h"

namespace lightwalk {
namespace {

// Tone-mapped value of the maximum luminance at the first exposure, and of the median at the last.
constexpr double exposure_level = 0.85;
constexpr float largest_hdr_value = 65536.0f;

// (a x² + b x) / (c x² + d x + e), including the pre-exposure.
namespace aces {
constexpr double pre_exposure = 0.6;
constexpr double a = 2.51 * pre_exposure * pre_exposure, b = 0.03 * pre_exposure;
constexpr double c = 2.43 * pre_exposure * pre_exposure, d = 0.59 * pre_exposure, e = 0.14;
}  // namespace aces

}  // namespace

float flip_tone_map(float linear) {
    // Exceeds 1 from 12.07 on; the bound prevents overflow.
    const double x = std::clamp(static_cast<double>(linear), 0.0, 1e3);
    return static_cast<float>(
        std::clamp((aces::a * x + aces::b) * x / ((aces::c * x + aces::d) * x + aces::e), 0.0, 1.0));
}

double flip_tone_map_inverse(double level) {
    // Positive root of level (c x² + d x + e) = a x² + b x.
    const double p = aces::a - level * aces::c, q = aces::b - level * aces::d, r = -level * aces::e;
    return (-q + std::sqrt(q * q - 4.0 * p * r)) / (2.0 * p);
}

ExposureRange exposure_range(float start, float stop) {
    if (!std::isfinite(start) || !std::isfinite(stop) || start > stop || stop - start > 64.0f)
        throw InputError("HDR-FLIP needs exposures in stops, start <= stop, at most 64 apart, not {:f} to {:f}", start,
                         stop);
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

ExposureRange automatic_exposures(const ImageRgb& reference) {
    const glm::dmat3 to_xyz = detail::rgb_to_xyz();
    std::vector<double> luminance;
    luminance.reserve(reference.pixels.size());
    for (const glm::vec3& p : reference.pixels)
        if (all_finite(p)) luminance.push_back((to_xyz * glm::dvec3(glm::clamp(p, 0.0f, largest_hdr_value))).y);
    if (luminance.empty()) throw InputError("HDR-FLIP: the reference has no finite pixel; give exposures explicitly");
    const double largest = *std::max_element(luminance.begin(), luminance.end());
    const double middle = median(luminance);
    if (!(middle > 0.0))
        throw InputError(
            "HDR-FLIP: half of the reference is black, so no exposure follows from its median luminance; "
            "give start and stop exposures explicitly");
    const double level = flip_tone_map_inverse(exposure_level);
    return exposure_range(static_cast<float>(std::log2(level / largest)),
                          static_cast<float>(std::log2(level / middle)));
}

ErrorMap flip_hdr(const ImageRgb& reference, const ImageRgb& test, std::optional<ExposureRange> exposures,
                  float pixels_per_degree) {
    const ExposureRange range =
        exposures ? exposure_range(exposures->start, exposures->stop) : automatic_exposures(reference);
    const auto exposed = [](const ImageRgb& image, float stops) {
        ImageRgb mapped = image;
        const float factor = std::exp2(stops);
        for (glm::vec3& p : mapped.pixels) {
            if (!all_finite(p)) continue;  // handled by flip_ldr()
            p = glm::clamp(p, 0.0f, largest_hdr_value) * factor;
            p = {flip_tone_map(p.x), flip_tone_map(p.y), flip_tone_map(p.z)};
        }
        return mapped;
    };
    ErrorMap worst{reference.width, reference.height, std::vector<float>(reference.pixels.size())};
    for (int i = 0; i < range.count; ++i) {
        const float stops = range.at(i);
        const ErrorMap map = flip_ldr(exposed(reference, stops), exposed(test, stops), pixels_per_degree);
        for (size_t p = 0; p < map.values.size(); ++p) worst.values[p] = std::max(worst.values[p], map.values[p]);
    }
    return worst;
}

ErrorSummary summarize(const ErrorMap& map) {
    if (map.values.empty()) return {};
    std::vector<float> sorted = map.values;
    std::sort(sorted.begin(), sorted.end());
    double total = 0.0;
    for (const float v : sorted) total += v;
    const auto weighted = [&](double share) {
        double below = 0.0;
        for (const float v : sorted)
            if ((below += v) >= share * total) return static_cast<double>(v);
        return static_cast<double>(sorted.back());
    };
    ErrorSummary summary;
    summary.mean = total / static_cast<double>(sorted.size());
    summary.p99 = percentile_of_sorted(sorted, 0.99);
    summary.max = sorted.back();
    summary.weighted_quartile1 = weighted(0.25);
    summary.weighted_median = weighted(0.5);
    summary.weighted_quartile3 = weighted(0.75);
    return summary;
}

glm::u8vec3 magma(float value) {
    constexpr std::array<glm::vec3, 17> points{{{0, 0, 4},
                                                {10, 8, 34},
                                                {29, 17, 70},
                                                {54, 16, 106},
                                                {80, 18, 124},
                                                {105, 28, 129},
                                                {130, 38, 129},
                                                {156, 46, 127},
                                                {182, 55, 121},
                                                {207, 65, 112},
                                                {230, 81, 99},
                                                {245, 105, 92},
                                                {251, 135, 97},
                                                {254, 165, 113},
                                                {254, 195, 135},
                                                {253, 224, 162},
                                                {252, 253, 191}}};
    const float at = (value > 0.0f ? std::min(value, 1.0f) : 0.0f) * float(points.size() - 1);
    const size_t i = std::min(static_cast<size_t>(at), points.size() - 2);
    return glm::u8vec3(glm::mix(points[i], points[i + 1], at - float(i)) + 0.5f);
}

Image8 heat_map(const ErrorMap& map) {
    Image8 image(map.width, map.height);
    for (size_t i = 0; i < map.values.size(); ++i) image.pixels[i] = glm::u8vec4(magma(map.values[i]), 255);
    return image;
}

}  // namespace lightwalk
