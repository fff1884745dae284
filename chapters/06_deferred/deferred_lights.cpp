#include "06_deferred/deferred_lights.h"

namespace lightwalk {

void DeferredLights::update(Frame& frame, const Scene& scene, const View& view, const GBuffer& gbuffer,
                            const Lights& lights) {
    is_tiled_ = gbuffer.method.is("tiled");
    has_volumes_ = gbuffer.volumes && !is_tiled_;
    if (has_volumes_) volumes_.update(frame, lights);
    if (is_tiled_)
        tiles_.set_view(view, scene.bounds, LightGrid::Cells::tiles, 1, 0,
                        lights.falloff.is("inverse_square") ? lights.threshold : 0.0f);
}

// [light]
void DeferredLights::light_pixels(Compute& pass, const ImageView& color, glm::vec3 ambient, glm::vec3 background,
                                  bool ggx, bool emits) const {
    const Macros variant{{"SURFACE_GGX", ggx ? "1" : "0"}, {"EMITS", emits ? "1" : "0"}};
    pass.use(is_tiled_ ? tiled_ : full_screen_, variant).set("hdr", color);
    pass.set("ambient", ambient).set("background", background);
    if (is_tiled_) pass.set("lights_grid", tiles_.view);
    if (has_volumes_) pass.set("without_volume", volumes_.without);
    pass.dispatch_threads(color.size());
}

void DeferredLights::light_volumes(Raster& pass, bool ggx) const {
    volumes_.draw(pass.use(volume_, {{"SURFACE_GGX", ggx ? "1" : "0"}}));
}
// [/light]

void DeferredLights::record(Frame& frame, const Scene& scene, glm::vec3 ambient, const View& view, Canvas& canvas,
                            const GBuffer& gbuffer, const Lights& lights, const std::vector<With>& with, bool ggx,
                            bool emits) {
    update(frame, scene, view, gbuffer, lights);
    const ImageView color = canvas.color_overwritten();
    std::vector<Resource> reads{canvas.depth(frame)};
    if (emits) reads.emplace_back(color);
    frame.compute(
        is_tiled_ ? "tiles" : "full_screen", {.reads = reads, .writes = {color}, .with = with},
        [&](Compute& pass) { light_pixels(pass, color, ambient, glm::vec3(canvas.background()), ggx, emits); });
    if (has_volumes_)
        frame.raster("volumes", {.color = {canvas.color_target()}, .depth = canvas.depth_read_only(), .with = with},
                     [&](Raster& pass) { light_volumes(pass, ggx); });
}

void DeferredLights::show(Frame& frame, Canvas& canvas, const GBuffer& gbuffer) {
    const ImageView color = canvas.color(frame);
    frame.compute("show", {.reads = {canvas.depth(frame), color}, .writes = {color}, .with = {gbuffer}},
                  [&](Compute& pass) { pass.use(show_).set("hdr", color).dispatch_threads(canvas.size()); });
}

}  // namespace lightwalk
