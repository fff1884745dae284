#include "05_shadow_maps/casting.h"

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

}  // namespace lightwalk
