#include "02_lambert_phong/directional_lights.h"

namespace lightwalk {

Buffer upload_directional_lights(Gpu& gpu, const std::vector<Light>& lights) {
    std::vector<DirectionalLight> packed;
    for (const Light& light : lights)
        if (light.kind == Light::Kind::directional)
            packed.push_back({-glm::normalize(light.direction), light.color * light.intensity});
    if (packed.empty()) packed.push_back({glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f)});
    return gpu.upload("lights", packed);
}

}  // namespace lightwalk
