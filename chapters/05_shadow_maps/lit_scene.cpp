#include "05_shadow_maps/lit_scene.h"

#include <functional>
#include <utility>

#include "05_shadow_maps/casting.h"

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

// Shadings from outside may lack a compute pipeline.
bool LitScene::shades_in_compute(const Canvas& canvas) const {
    return shaded_ && shaded_->is("visibility") && (!shading.opaque || shading.seen) &&
           VisibilityBuffer::suits(maps, canvas);
}

void LitScene::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!shades_in_compute(canvas)) return draw_lit(frame, view, canvas);
    const auto sort = [&] {
        lights.record(frame, surfaces.scene(), view, canvas.single_depth());
        record_shadows(frame, view);
    };
    draw_visible(frame, canvas, sort, surfaces.opaque_batches());
}

void LitScene::draw_lit(Frame& frame, const View& view, Canvas& canvas) {
    surfaces.draw_lit(frame, canvas, [&] {
        lights.record(frame, surfaces.scene(), view, canvas.single_depth());
        record_shadows(frame, view);
    });
}

void LitScene::draw_visible(Frame& frame, Canvas& canvas, const std::function<void()>& sort,
                            const std::vector<Batch>& drawn) {
    visible.record(frame, surfaces.scene(), maps, drawn, canvas);
    sort();
    visible.shade(frame, surfaces.scene(), maps, surfaces.opaque_batches(), canvas, compute_pipeline(),
                  surfaces.given(), shading.reads);
}

// Solid casters need no maps; casters with holes are drawn with theirs.
Shadow::Casters LitScene::casters(const Frame& frame) const {
    const Scene& scene = surfaces.scene();
    const auto draw = [this, &scene](Raster& pass, const DrawList& casters) {
        const auto has_holes = [&](const DrawItem& item) { return maps.has_holes(item); };
        pass.use(shadow.solid).draw(casters.where(std::not_fn(has_holes)));
        maps.draw(pass, scene, casters.where(has_holes), caster_, caster_);
    };
    const auto by = [this, &scene](const SurfacePipelines& both) {
        return [this, &scene, &both](Raster& pass, const DrawList& casters) {
            maps.draw(pass, scene, casters, both.loaded, both.displaced);
        };
    };
    Shadow::Casters all{{maps}, draw, by(first_), by(passed_)};
    all.others_placed = holes_cut(maps, scene, frame.time_s);
    if (!scene.items.empty()) casting_.add_to(all);  // an empty scene receives no shadows
    return all;
}

}  // namespace lightwalk
