#include "06_deferred/deferred_lights.h"

namespace lightwalk {

// [record]
void DeferredLights::record(Frame& frame, const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                            const Lights& lights, const std::vector<With>& with) {
    const bool tiled = gbuffer.method.is("tiled"), volumes = gbuffer.volumes && !tiled;
    std::vector<Resource> reads{frame.depth};
    if (volumes) volumes_.update(frame, lights);
    if (tiled) {
        tiles_.set_view(frame, camera, scene.bounds, LightGrid::Cells::tiles, 1, 0,
                        lights.falloff.is("inverse_square") ? lights.threshold : 0.0f);
    }

    // 1. Every pixel once: ambient light, and the lights that it computes here.
    frame.compute(tiled ? "tiles" : "full_screen", {.reads = reads, .writes = {frame.hdr}, .with = with},
                  [&](Compute& pass) {
                      pass.use(tiled ? tiled_ : full_screen_).set("hdr", frame.hdr);
                      pass.set("ambient", scene.file.ambient).set("background", scene.file.background);
                      if (tiled) pass.set("lights_grid", tiles_.view);
                      if (volumes) pass.set("without_volume", volumes_.without);
                      pass.dispatch_threads(frame.size);
                  });

    // 2. The other lights, one by one, where they may reach.
    if (volumes)
        frame.raster("volumes", {.color = {keep(frame.hdr)}, .depth = read_only(frame.depth), .with = with},
                     [&](Raster& pass) { volumes_.draw(pass.use(volume_)); });
}
// [/record]

void DeferredLights::show(Frame& frame, const GBuffer& gbuffer) {
    frame.compute("show", {.reads = {frame.depth, frame.hdr}, .writes = {frame.hdr}, .with = {gbuffer}},
                  [&](Compute& pass) { pass.use(show_).set("hdr", frame.hdr).dispatch_threads(frame.size); });
}

}  // namespace lightwalk
