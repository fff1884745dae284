#include "19_ambiance/climbing_lights.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/color_space.hpp>

namespace lightwalk {

// Spirals with steps of the golden angle. Each light is born at the foot, and fades out at the top.
LightList ClimbingLights::all_lights(const Frame& frame) {
    const LightList others = ManyLights::all_lights(frame);
    std::vector<Light> all = *others;
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < climbers; ++i) {
        const double speed = 0.12 + 0.1 * std::fmod(7 * golden * i, 1.0);  // of the height, in a second
        const double high = std::fmod(golden * i + speed * static_cast<double>(frame.time_s), 1.0);
        const double around = glm::two_pi<double>() * (std::fmod(3 * golden * i, 1.0) + 0.7 * high);
        const double wide = static_cast<double>(girth_m) * (1 - 0.45 * high), tall = static_cast<double>(figure_m);
        Light light{.kind = Light::Kind::point, .range_m = 0.15f * figure_m};
        light.position = foot.value + glm::vec3(wide * std::cos(around), tall * high, wide * std::sin(around));
        light.color = glm::rgbColor(glm::vec3(360 * std::fmod(5 * golden * i, 1.0), 0.95f, 1.0f));
        light.intensity = static_cast<float>(0.2 * std::min(1.0, 6 * std::min(high, 1 - high)));
        all.push_back(light);
    }
    return std::make_shared<const std::vector<Light>>(std::move(all));
}

}  // namespace lightwalk
