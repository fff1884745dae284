#include "05_shadow_maps/holes.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/app/settings.h"
#include "common/base/files.h"

namespace lightwalk {

uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s) {
    std::string now = settings_of(maps);
    const auto is_cut = [&](const DrawItem& item) { return item.transparent || maps.has_holes(item); };
    if (maps.animated() && std::any_of(scene.items.begin(), scene.items.end(), is_cut))
        now += fmt::format("{}", time_s);
    return hash_bytes(now);
}

}  // namespace lightwalk
