#include "03_attenuation/object_lights.h"

#include "03_attenuation/exercises.h"

namespace lightwalk {

void ObjectLights::update(Frame& frame, const Scene& scene, const LightBuffer& buffer, float threshold) {
    if (made_.is_current(buffer.rebuilds, scene.epoch, threshold, Exercises::epoch())) return;
    std::vector<float> radii_m;
    for (const Light& light : buffer.lights()) radii_m.push_back(influence_radius(pack(light), threshold));
    const auto reaches = light_reaches_box.function();
    std::vector<uint32_t> list, list_ends;
    for (const DrawItem& item : scene.items) {
        for (uint32_t i = 0; i < radii_m.size(); ++i)
            if (reaches(buffer.lights()[i], radii_m[i], item.bounds)) list.push_back(i);
        list_ends.push_back(static_cast<uint32_t>(list.size()));
    }
    frame.upload("object ends", ends, list_ends);
    frame.upload("object lights", lights, list);
}

}  // namespace lightwalk
