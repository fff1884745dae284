#include "03_attenuation/light_buffer.h"

#include <cmath>

namespace lightwalk {

LightData pack(const Light& light) {
    return {.position = light.position,
            .range = light.range_m,
            .direction = light.direction,
            .kind = light.kind == Light::Kind::directional ? LIGHT_DIRECTIONAL
                    : light.kind == Light::Kind::point     ? LIGHT_POINT
                                                           : LIGHT_SPOT,
            .radiance = light.color * light.intensity,
            .softness = light.softness,
            .cos_inner = std::cos(light.inner_rad),
            .cos_outer = std::cos(light.outer_rad),
            .radius = light.kind == Light::Kind::directional ? std::tan(0.5f * light.size_rad) : 0.5f * light.size_m,
            .half_tube = 0.5f * light.tube_m};
}

// [update]
bool LightBuffer::update(Frame& frame, const LightList& lights) {
    if (buffer && (lights == lights_ || *lights == *lights_)) return false;
    lights_ = lights;
    std::vector<LightData> packed;
    packed.reserve(lights->size());
    for (const Light& light : *lights) packed.push_back(pack(light));
    frame.upload("lights", buffer, packed);
    ++rebuilds;
    return true;
}
// [/update]

bool LightBuffer::update(Frame& frame, const std::vector<Light>& lights) {
    if (buffer && lights == *lights_) return false;
    return update(frame, std::make_shared<const std::vector<Light>>(lights));
}

}  // namespace lightwalk
