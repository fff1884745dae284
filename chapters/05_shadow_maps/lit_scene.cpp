#include "05_shadow_maps/lit_scene.h"

#include <functional>

#include "05_shadow_maps/holes.h"

namespace lightwalk {

std::vector<With> LitScene::given() const {
    std::vector<With> with = SurfaceScene::given();
    with.push_back(shadow);
    return with;
}

// A shading that somebody else gave is a fragment shader.
// [visibility]
bool LitScene::shades_seen(const Canvas& canvas) const {
    return shaded && shaded->is("visibility") && !shading && VisibilityBuffer::suits(maps, canvas);
}

void LitScene::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!shades_seen(canvas)) return SurfaceScene::draw(frame, view, canvas);
    draw_seen(frame, canvas, [&] { record_light(frame, view, canvas.single_depth()); });
}

void LitScene::draw_seen(Frame& frame, Canvas& canvas, const std::function<void()>& cells, int times) {
    const std::vector<Batch> once = opaque_batches();
    std::vector<Batch> drawn;
    for (int i = 0; i < times; ++i) drawn.insert(drawn.end(), once.begin(), once.end());
    seen_.record(frame, *scene_, maps, drawn, canvas);
    cells();
    seen_.shade(frame, *scene_, maps, once, canvas, shade_seen_, given());
}
// [/visibility]

void LitScene::record_light(Frame& frame, const View& view, const ImageView& depth) {
    SurfaceScene::record_light(frame, view, depth);
    record_shadows(frame, view);
}

// [casters]
// Casters with holes cut by textures are drawn with their maps; all others are solid.
void LitScene::record_shadows(Frame& frame, const View& view) {
    const auto has_holes = [&](const DrawItem& item) { return maps.has_holes(item); };
    const auto draw = [&](Raster& pass, const DrawList& casters) {
        pass.use(shadow.solid).draw(casters.where(std::not_fn(has_holes)));
        maps.draw(pass, *scene_, casters.where(has_holes), caster_, caster_);
    };
    const auto by = [&](const SurfacePipelines& both) {
        return [&](Raster& pass, const DrawList& casters) {
            maps.draw(pass, *scene_, casters, both.loaded, both.displaced);
        };
    };
    Shadow::Casters casters{{maps}, draw, by(first_), by(passed_)};
    casters.others_placed = holes_cut(maps, *scene_, frame.time_s);
    shadow.record(frame, *scene_, lights, view, casters);
}
// [/casters]

}  // namespace lightwalk
