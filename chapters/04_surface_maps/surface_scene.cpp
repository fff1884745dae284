#include "04_surface_maps/surface_scene.h"

namespace lightwalk {

SurfaceScene::SurfaceScene(Module& owner, std::string name)
    : SurfaceScene(owner, std::move(name), "04_surface_maps/lit.frag") {}

SurfaceScene::SurfaceScene(Module& owner, std::string name, const char* fragment)
    : Drawing(owner, std::move(name)),
      maps(owner, "maps"),
      lights(owner, "lights"),
      shade_({.fragment = fragment}),
      see_through_(see_through(fragment, {})),
      see_through_tiles_(see_through(fragment, {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}})) {}

SurfacePipelines SurfaceScene::see_through(const char* fragment, Macros macros) {
    macros.set("TRANSPARENT", "1");
    return SurfacePipelines(
        {.fragment = fragment, .depth_write = false, .blend = Blend::alpha, .macros = std::move(macros)});
}

void SurfaceScene::update(Frame& frame) {
    lights.update(frame, *scene_, all_lights ? all_lights(frame) : scene_->lights());
}

std::vector<With> SurfaceScene::given() const {
    std::vector<With> with{maps, lights};
    with.insert(with.end(), shading_with.begin(), shading_with.end());
    return with;
}

std::vector<Batch> SurfaceScene::opaque_batches() const { return surfaces ? surfaces() : scene_->opaque().batches(); }

std::function<void(Raster&)> SurfaceScene::by(const SurfacePipelines& both) const {
    return [this, &both, batches = opaque_batches()](Raster& pass) {
        maps.draw(pass, *scene_, batches, both.loaded, both.displaced);
    };
}

void SurfaceScene::record_light(Frame& frame, const View& view, const ImageView& depth) {
    lights.record(frame, *scene_, view, depth);
}

// [draw]
void SurfaceScene::draw_lit(Frame& frame, const View& view, Canvas& canvas) {
    // 1. Lights into the view's tiles or clusters, if one of these is the method. Tiles need the depth.
    if (lights.needs_depth())
        frame.raster("depth", {.depth = canvas.single_depth_target(), .reads = shading_reads, .with = {maps}},
                     by(depth_));
    record_light(frame, view, canvas.single_depth());

    // 2. All opaque surfaces.
    frame.raster(
        "shade",
        {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .reads = shading_reads, .with = given()},
        by(shading ? *shading : shade_));
}
// [/draw]

// [transparent]
std::vector<Drawing::Transparent> SurfaceScene::transparent(const View& view) const {
    std::vector<Transparent> all;
    const DrawList list = scene_->transparent();
    for (const uint32_t i : list.items()) all.push_back({glm::length(scene_->items[i].bounds.center() - view.eye), i});
    return all;
}

void SurfaceScene::draw_transparent(Raster& pass, std::span<const Transparent> items, const Macros&) const {
    std::vector<Batch> one_by_one;
    for (const Transparent& item : items) one_by_one.emplace_back(*scene_, item.item, 1u);
    const SurfacePipelines& both = transparent_shading         ? *transparent_shading
                                   : lights.method.is("tiled") ? see_through_tiles_
                                                               : see_through_;
    maps.draw(pass, *scene_, one_by_one, both.loaded, both.displaced);
}
// [/transparent]

}  // namespace lightwalk
