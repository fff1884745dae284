#include "06_deferred/deferred_lights.h"

namespace lightwalk {

// [record]
void DeferredLights::record(Frame& frame, const Scene& scene, glm::vec3 ambient, const View& view, Canvas& canvas,
                            const GBuffer& gbuffer, const Lights& lights, const std::vector<With>& with, bool ggx,
                            bool emits) {
    const Macros model{{"SURFACE_GGX", ggx ? "1" : "0"}, {"EMITS", emits ? "1" : "0"}};
    const bool tiled = gbuffer.method.is("tiled"), volumes = gbuffer.volumes && !tiled;
    if (volumes) volumes_.update(frame, lights);
    if (tiled)
        tiles_.set_view(view, scene.bounds, LightGrid::Cells::tiles, 1, 0,
                        lights.falloff.is("inverse_square") ? lights.threshold : 0.0f);
    const ImageView color = canvas.color_overwritten();
    std::vector<Resource> reads{canvas.depth(frame)};
    if (emits) reads.push_back(color);

    // 1. Every pixel once: ambient light, and the lights that it computes here.
    frame.compute(tiled ? "tiles" : "full_screen", {.reads = reads, .writes = {color}, .with = with},
                  [&](Compute& pass) {
                      pass.use(tiled ? tiled_ : full_screen_, model).set("hdr", color);
                      pass.set("ambient", ambient).set("background", glm::vec3(canvas.background()));
                      if (tiled) pass.set("lights_grid", tiles_.view);
                      if (volumes) pass.set("without_volume", volumes_.without);
                      pass.dispatch_threads(view.size);
                  });

    // 2. The other lights, one by one, where they may reach.
    if (volumes)
        frame.raster("volumes", {.color = {canvas.color_target()}, .depth = canvas.depth_read_only(), .with = with},
                     [&](Raster& pass) { volumes_.draw(pass.use(volume_, model)); });
}
// [/record]

void DeferredLights::show(Frame& frame, Canvas& canvas, const GBuffer& gbuffer) {
    const ImageView color = canvas.color(frame);
    frame.compute("show", {.reads = {canvas.depth(frame), color}, .writes = {color}, .with = {gbuffer}},
                  [&](Compute& pass) { pass.use(show_).set("hdr", color).dispatch_threads(canvas.size()); });
}

}  // namespace lightwalk
