#include "05_shadow_maps/lit_stage.h"

#include <algorithm>
#include <utility>

namespace lightwalk {

const LightList& LitStage::lamps() {
    const LightList own = scene().lights();
    if (own == own_ && lamps_made_.is_current(epoch())) return lamps_;
    own_ = own;
    std::vector<Light> all = *own;
    for (Light& light : all) {
        light.size_m *= lamp;
        light.size_rad = std::min(light.size_rad * lamp, 1.5f);
    }
    lamps_ = std::make_shared<const std::vector<Light>>(std::move(all));
    return lamps_;
}

// [shading]
// Rays only if needed; planets with rings have analytic shadows.
void LitStage::choose_shading(Frame& frame) {
    const bool asks_rays = visibility.is("rays") || show.is("wrong"), plain = show.is("picture") && !asks_rays;
    sphere_shadow.update(scene());
    Shading shading;
    if (sphere_shadow)
        shading = {
            .opaque = &sphere_shadow.ringed, .transparent = &sphere_shadow.ringed_transparent, .with = {sphere_shadow}};
    else if (!plain)
        shading = {.opaque = &shown_, .seen = &shown_seen_};
    if (!plain) {
        rays.record(frame, scene(), &objects.maps);
        shading.with.emplace_back(rays);
    }
    objects.shading = std::move(shading);
}
// [/shading]

}  // namespace lightwalk
