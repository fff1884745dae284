#include "05_shadow_maps/lit_scene.h"

#include <functional>
#include <utility>

#include "05_shadow_maps/holes.h"

namespace lightwalk {

LitScene::LitScene(Module& owner, std::string name, std::optional<Shading> fixed)
    : Drawing(owner, name), surfaces(owner, name, "05_shadow_maps/surface.frag"), shadow(owner, "shadow") {
    surfaces.shadows = &shadow;
    if (!fixed || fixed->seen) shaded_.emplace(*this);
    if (fixed) shading = std::move(*fixed);
}

std::vector<const Module*> LitScene::dependencies() const {
    std::vector<const Module*> all = surfaces.dependencies();
    all.push_back(this);
    return all;
}

// A shading that somebody else gave may be a fragment shader alone.
// [visibility]
bool LitScene::shades_in_compute(const Canvas& canvas) const {
    return shaded_ && shaded_->is("visibility") && (!shading.opaque || shading.seen) &&
           VisibilityBuffer::suits(maps, canvas);
}

void LitScene::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!shades_in_compute(canvas)) return draw_lit(frame, view, canvas);
    draw_visible(frame, canvas, [&] {
        lights.record(frame, surfaces.scene(), view, canvas.single_depth());
        record_shadows(frame, view);
    });
}

void LitScene::draw_lit(Frame& frame, const View& view, Canvas& canvas) {
    surfaces.draw_lit(frame, canvas, [&] {
        lights.record(frame, surfaces.scene(), view, canvas.single_depth());
        record_shadows(frame, view);
    });
}

void LitScene::draw_visible(Frame& frame, Canvas& canvas, const std::function<void()>& sort, int times) {
    const std::vector<Batch> once = surfaces.opaque_batches();
    std::vector<Batch> drawn;
    for (int i = 0; i < times; ++i) drawn.insert(drawn.end(), once.begin(), once.end());
    seen_.record(frame, surfaces.scene(), maps, drawn, canvas);
    sort();
    seen_.shade(frame, surfaces.scene(), maps, once, canvas, shading.seen ? *shading.seen : shade_seen_,
                surfaces.given(), shading.reads);
}
// [/visibility]

// [casters]
// Casters with holes cut by textures are drawn with their maps; all others are solid.
void LitScene::record_shadows(Frame& frame, const View& view) {
    const Scene& scene = surfaces.scene();
    const auto has_holes = [&](const DrawItem& item) { return maps.has_holes(item); };
    const auto draw = [&](Raster& pass, const DrawList& casters) {
        pass.use(shadow.solid).draw(casters.where(std::not_fn(has_holes)));
        maps.draw(pass, scene, casters.where(has_holes), caster_, caster_);
    };
    const auto by = [&](const SurfacePipelines& both) {
        return [&](Raster& pass, const DrawList& casters) {
            maps.draw(pass, scene, casters, both.loaded, both.displaced);
        };
    };
    Shadow::Casters casters{{maps}, draw, by(first_), by(passed_)};
    casters.others_placed = holes_cut(maps, scene, frame.time_s);
    if (!scene.items.empty()) casting_.add_to(casters);  // else nothing would be shaded
    shadow.record(frame, scene, lights, view, casters);
}
// [/casters]

}  // namespace lightwalk
