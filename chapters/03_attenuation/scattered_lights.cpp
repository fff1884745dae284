#include "03_attenuation/scattered_lights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/color_space.hpp>
#include <glm/gtx/color_space.hpp>
#include <numbers>

namespace lightwalk {

// C++'s distributions differ between libraries. The mixing is C. Wellons' "lowbias32" (2018).
float scattered_number(unsigned seed, uint32_t item, uint32_t which) {
    uint32_t x = seed * 0x9e3779b9u + item * 16u + which;
    for (int round = 0; round < 2; ++round) {
        x ^= x >> 16;
        x *= 0x7feb352du;
        x ^= x >> 15;
        x *= 0x846ca68bu;
        x ^= x >> 16;
    }
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

std::vector<Light> scatter_lights(const Bounds& where, int count, unsigned seed) {
    std::vector<Light> lights;
    const glm::vec3 extent = where.extent();
    const float spacing_m = std::sqrt(extent.x * extent.z / static_cast<float>(std::max(count, 1)));
    const float range_m = std::clamp(1.6f * spacing_m, 0.2f, 6.0f);
    for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
        const auto in = [&](uint32_t which, float lower, float upper) {
            return lower + (upper - lower) * scattered_number(seed, i, which);
        };
        Light light{.kind = i % 3 == 2 ? Light::Kind::spot : Light::Kind::point, .range_m = range_m};
        const float height_m = range_m * (light.kind == Light::Kind::spot ? in(0, 0.4f, 0.7f) : in(0, 0.08f, 0.3f));
        light.position = where.lower + glm::vec3(extent.x * in(1, 0, 1), height_m, extent.z * in(2, 0, 1));
        light.color = glm::rgbColor(glm::vec3(in(3, 0, 360), in(4, 0.55f, 0.95f), 1.0f));
        light.intensity = in(5, 0.5f, 1.0f) * (1.0f + height_m * height_m);
        if (light.kind == Light::Kind::spot) {
            light.direction = glm::normalize(glm::vec3(in(6, -0.5f, 0.5f), -1.0f, in(7, -0.5f, 0.5f)));
            light.outer_rad = glm::radians(in(8, 18, 34));
            light.inner_rad = light.outer_rad * in(9, 0.4f, 1.0f);
            light.softness = in(10, 0, 1);
            light.intensity *= 2.0f;
        }
        lights.push_back(light);
    }
    return lights;
}

ScatteredLights::ScatteredLights(Module& owner)
    : Module(owner, "scattered"),
      count(owner, "lights", 0, {0, 1000000}, "Number of random lights added to those of the scene") {}

const LightList& LightsWithScattered::from(const LightList& own, const Bounds& where, int count, unsigned seed,
                                           std::optional<float> moved_at_s) {
    if (own != own_ || !still_made_.is_current(where.lower, where.upper, count, seed)) {
        own_ = own;
        moved_made_.forget();
        std::vector<Light> all = *own;
        const std::vector<Light> more = scatter_lights(where, count, seed);
        all.insert(all.end(), more.begin(), more.end());
        still_ = std::make_shared<const std::vector<Light>>(std::move(all));
    }
    if (!moved_at_s) return still_;
    if (!moved_made_.is_current(moved_at_s)) {
        std::vector<Light> all = *still_;
        move_lights(all, *moved_at_s);
        moved_ = std::make_shared<const std::vector<Light>>(std::move(all));
    }
    return moved_;
}

void move_lights(std::vector<Light>& lights, float time_s) {
    for (uint32_t i = 0; i < lights.size(); ++i) {
        Light& light = lights[i];
        if (light.kind == Light::Kind::directional) continue;
        const float period_s = 2.0f + 4.0f * scattered_number(7, i, 0),
                    radius_m = std::min(0.5f, 0.25f * light.range_m);
        const float angle = 2.0f * std::numbers::pi_v<float> * (time_s / period_s + scattered_number(7, i, 1));
        light.position += radius_m * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
    }
}

}  // namespace lightwalk
