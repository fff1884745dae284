#include "05_shadow_maps/casting.h"

#include <algorithm>

namespace lightwalk {

Casting::Casting(const Drawings& drawings) {
    for (const Drawing& drawing : drawings) {
        if (const auto* caster = dynamic_cast<const Caster*>(&drawing)) others_.push_back(caster);
        if (const auto* objects = dynamic_cast<const ItemCaster*>(&drawing)) maps_ = &objects->cut_by();
    }
}

void Casting::add_to(Shadow::Casters& casters) const {
    for (const Caster* caster : others_) {
        if (caster->bounds().empty()) continue;
        casters.others.add(caster->bounds());
        casters.others_placed = casters.others_placed * 1000003 + caster->placed();
        for (const With& with : caster->shadow_modules()) casters.with.push_back(with);
    }
    if (casters.others.empty()) return;
    casters.draw_others = [casting = others_](Raster& pass, const View& light) {
        for (const Caster* caster : casting)
            if (!caster->bounds().empty()) caster->cast(pass, light);
    };
}

uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s) {
    const auto is_cut = [&](const DrawItem& item) { return item.transparent || maps.has_holes(item); };
    const bool moves = maps.animated() && std::any_of(scene.items.begin(), scene.items.end(), is_cut);
    return hash_of(maps.epoch(), moves ? time_s : 0.0f);
}

}  // namespace lightwalk
