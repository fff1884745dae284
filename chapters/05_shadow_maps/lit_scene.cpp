#include "05_shadow_maps/lit_scene.h"

namespace lightwalk {

std::vector<With> LitScene::given() const {
    std::vector<With> with = SurfaceScene::given();
    with.push_back(shadow);
    return with;
}

void LitScene::record_light(Frame& frame, const View& view, const ImageView& depth) {
    SurfaceScene::record_light(frame, view, depth);
    record_shadows(frame, view);
}

// [casters]
// Casters with holes cut by textures are drawn with their maps; all others are solid.
void LitScene::record_shadows(Frame& frame, const View& view) {
    const auto has_holes = [&](const DrawItem& item) { return maps.has_holes(item); };
    shadow.record(frame, *scene_, lights, view, {.with = {maps}, .draw = [&](Raster& pass, const DrawList& casters) {
                                                     pass.use(shadow.solid).draw(casters.where(std::not_fn(has_holes)));
                                                     maps.draw(pass, *scene_, casters.where(has_holes), caster_,
                                                               caster_);
                                                 }});
}
// [/casters]

}  // namespace lightwalk
