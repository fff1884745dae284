#include "05_shadow_maps/holes.h"

#include <algorithm>

namespace lightwalk {

uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s) {
    const auto is_cut = [&](const DrawItem& item) { return item.transparent || maps.has_holes(item); };
    const bool moves = maps.animated() && std::any_of(scene.items.begin(), scene.items.end(), is_cut);
    return hash_of(maps.epoch(), moves ? time_s : 0.0f);
}

}  // namespace lightwalk
