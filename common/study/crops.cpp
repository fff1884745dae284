#include "common/study/crops.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace lightwalk {
namespace {

double mean_between(const ErrorMap& map, glm::uvec2 lower, glm::uvec2 upper) {
    double sum = 0;
    for (unsigned y = lower.y; y < upper.y; ++y)
        for (unsigned x = lower.x; x < upper.x; ++x) sum += double(map.at(int(x), int(y)));
    return sum / (double(upper.x - lower.x) * double(upper.y - lower.y));
}

}  // namespace

std::vector<CropPlace> cut(glm::uvec2 whole) {
    constexpr unsigned core_px = crop_px - 2 * crop_margin_px;
    std::vector<CropPlace> places;
    for (unsigned y = 0; y < whole.y; y += core_px)
        for (unsigned x = 0; x < whole.x; x += core_px) {
            const glm::uvec2 lower(x, y), upper = glm::min(lower + core_px, whole);
            const glm::uvec2 size = upper - lower;
            places.push_back({.lower = lower,
                              .upper = upper,
                              .origin = glm::min(glm::max(lower, crop_margin_px) - crop_margin_px, whole - crop_px),
                              .share = double(size.x) * size.y / (double(whole.x) * whole.y)});
        }
    return places;
}

double mean_over(const ErrorMap& map, glm::uvec2 whole, const CropPlace& place) {
    const glm::dvec2 scale = glm::dvec2(map.width, map.height) / glm::dvec2(whole);
    const glm::uvec2 lower(glm::dvec2(place.lower) * scale), upper(glm::ceil(glm::dvec2(place.upper) * scale));
    return mean_between(map, lower, glm::min(upper, glm::uvec2(map.width, map.height)));
}

double mean_of_crop(const ErrorMap& map, const CropPlace& place) {
    return mean_between(map, place.lower - place.origin, place.upper - place.origin);
}

std::vector<size_t> draw_places(std::span<const double> chances, size_t count, double start) {
    std::vector<size_t> drawn;
    double sum = 0;
    const auto target = [&] {
        const double turns = start + golden_ratio * static_cast<double>(drawn.size());
        return static_cast<double>(drawn.size()) + turns - std::floor(turns);
    };
    for (size_t i = 0; i < chances.size(); ++i) {
        sum += chances[i] * static_cast<double>(count);
        while (drawn.size() < count && target() < sum) drawn.push_back(i);
    }
    while (drawn.size() < count) drawn.push_back(chances.size() - 1);  // the sum was rounded down
    return drawn;
}

double Estimate::mean() const {
    return std::accumulate(draws_.begin(), draws_.end(), 0.0) / static_cast<double>(draws_.size());
}

double Estimate::standard_error() const {
    if (draws_.size() < 2) return std::numeric_limits<double>::infinity();
    const double middle = mean(), n = static_cast<double>(draws_.size());
    double squares = 0;
    for (const double draw : draws_) squares += (draw - middle) * (draw - middle);
    return std::sqrt(squares / (n * (n - 1)));
}

}  // namespace lightwalk
