#include "15_terrain_water/ground_heights.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lightwalk {

std::optional<float> GroundHeights::height_at(const glm::dvec2& place) const {
    const glm::dvec2 at = (place - glm::dvec2(map.corner)) / double(map.spacing_m);
    const int last = map.samples - 1;
    if (heights_m.empty() || !(at.x >= 0 && at.y >= 0 && at.x <= last && at.y <= last)) return std::nullopt;
    const int x = std::min(int(at.x), last - 1), y = std::min(int(at.y), last - 1);
    const auto sample = [&](int dx, int dy) {
        return double(heights_m[size_t(y + dy) * size_t(map.samples) + size_t(x + dx)]);
    };
    const double fx = at.x - x, fy = at.y - y;
    return float(glm::mix(glm::mix(sample(0, 0), sample(1, 0), fx), glm::mix(sample(0, 1), sample(1, 1), fx), fy));
}

std::optional<GroundHeights::Met> GroundHeights::met_by(const PickRay& ray, float most_m) const {
    if (heights_m.empty()) return std::nullopt;
    const glm::dvec3 origin(ray.origin), direction(ray.direction);
    const auto above = [&](double t) -> std::optional<double> {
        const glm::dvec3 at = origin + t * direction;
        const auto height = height_at({at.x, at.z});
        return height ? std::optional(at.y - double(*height)) : std::nullopt;
    };
    const double step = std::max(0.5 * double(map.spacing_m), double(most_m) / 50000);
    double before_t = 0;
    std::optional<double> before = above(0);
    while (before_t < double(most_m)) {
        const double t = std::min(before_t + step, double(most_m));
        const auto now = above(t);
        if (before && now && *before > 0 && *now <= 0) {
            double low = before_t, high = t;
            for (int i = 0; i < 40; ++i) {
                const double middle = 0.5 * (low + high);
                (above(middle).value_or(0) > 0 ? low : high) = middle;
            }
            const glm::dvec3 at = origin + high * direction;
            const double reach = 0.5 * double(map.spacing_m);
            const auto near = [&](double x, double z) { return double(height_at({x, z}).value_or(float(at.y))); };
            const glm::dvec3 normal(near(at.x - reach, at.z) - near(at.x + reach, at.z), 2 * reach,
                                    near(at.x, at.z - reach) - near(at.x, at.z + reach));
            return Met{float(high), glm::vec3(glm::normalize(normal))};
        }
        before = now;
        before_t = t;
    }
    return std::nullopt;
}

GroundHeights read_heights(Gpu& gpu, const Ground& ground) {
    if (!ground.exists() || !ground.heights()) return {};
    const std::vector<std::byte> bytes = gpu.read_back(ground.heights());
    GroundHeights all{ground.map(), std::vector<float>(bytes.size() / sizeof(float))};
    std::memcpy(all.heights_m.data(), bytes.data(), bytes.size());
    return all;
}

}  // namespace lightwalk
