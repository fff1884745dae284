#include "15_terrain_water/sun_shadow.h"

namespace lightwalk {

SunShadow::SunShadow(Module& owner, std::string name, const Atmosphere& atmosphere)
    : Module(owner, std::move(name), "sun_shadow"), atmosphere_(atmosphere) {}

// [sun_shadow_record]
void SunShadow::record(Frame& frame, const View& view, const Scene& scene, const Drawings& drawings) {
    std::vector<const SunCaster*> casting;
    Bounds others;
    uint64_t placed = 0;
    Shadow::Casters casters{};
    for (Drawing& drawing : drawings) {
        if (auto* receiver = dynamic_cast<SunReceiver*>(&drawing)) receiver->shadowed_by = this;
        const auto* caster = dynamic_cast<const SunCaster*>(&drawing);
        if (!caster) continue;
        drawing.update_once(frame);
        casting.push_back(caster);
        if (!caster->bounds().empty()) others.add(caster->bounds());
        placed = placed * 1000003 + caster->placed();
        for (const With& with : caster->casts_with()) casters.with.push_back(with);
    }
    Bounds all = scene.bounds;
    if (!others.empty()) all.add(others);
    const glm::vec3 to_sun = atmosphere_.to_sun();
    exists_ = !all.empty() && to_sun.y > 0 && !maps.method.is("none");
    if (!exists_) return;
    const Light sun{.direction = -to_sun, .shadow = true, .size_rad = glm::radians(atmosphere_.sun_deg.value)};
    casters.draw_others = [&](Raster& pass, const View& light) {
        for (const SunCaster* caster : casting) caster->cast(pass, light);
    };
    casters.others = others, casters.others_placed = placed;
    maps.record(frame, scene, std::vector<Light>{sun}, view, casters);
}
// [/sun_shadow_record]

bool add_shadow(const SunShadow* shadow, std::vector<With>& with) {
    const bool has_maps = shadow && shadow->exists();
    if (has_maps) with.push_back(shadow->maps);
    return has_maps;
}

}  // namespace lightwalk
