#include "15_terrain_water/sun_shadow.h"

namespace lightwalk {

SunShadow::SunShadow(Module& owner, std::string name, const Atmosphere& atmosphere)
    : Module(owner, std::move(name), "sun_shadow"), atmosphere_(atmosphere) {}

void SunShadow::record(Frame& frame, const View& view, const Scene& scene, const Drawings& drawings) {
    for (Drawing& drawing : drawings) {
        if (auto* receiver = dynamic_cast<SunReceiver*>(&drawing)) receiver->shadowed_by = this;
        if (dynamic_cast<const Caster*>(&drawing)) drawing.update_once(frame);
    }
    Shadow::Casters casters{};
    Casting(drawings).add_to(casters);
    Bounds all = scene.bounds;
    if (!casters.others.empty()) all.add(casters.others);
    const glm::vec3 to_sun = atmosphere_.to_sun();
    exists_ = !all.empty() && to_sun.y > 0 && !maps.method.is("none");
    if (!exists_) return;
    const Light sun{.direction = -to_sun, .shadow = true, .size_rad = glm::radians(atmosphere_.sun_deg.value)};
    maps.record(frame, scene, std::vector<Light>{sun}, view, casters);
}

bool add_shadow(const SunShadow* shadow, std::vector<With>& with) {
    const bool has_maps = shadow && shadow->exists();
    if (has_maps) with.push_back(shadow->maps);
    return has_maps;
}

}  // namespace lightwalk
