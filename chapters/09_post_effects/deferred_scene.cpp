#include "09_post_effects/deferred_scene.h"

#include "common/base/error.h"

namespace lightwalk {

// The chapter's own modules: their options and scene keys are those of the chapters before.
DeferredScene::DeferredScene(Module& owner, std::string name)
    : Module(owner, std::move(name)),
      maps(owner, "maps"),
      lights(owner, "lights"),
      shadow(owner, "shadow"),
      gbuffer(owner, "gbuffer") {
    maps.method.change_default("normal");
}

void DeferredScene::prepare(Gpu& gpu, Scene& scene) {
    maps.prepare(gpu, scene);
    shadow.forget();
}

Shadow::Casters DeferredScene::casters(const Scene& scene) const {
    return {.with = {maps}, .draw = [&](Raster& pass, const DrawList& list) {
                const DrawList holed = list.where([&](const DrawItem& one) { return maps.has_holes(one); });
                pass.use(shadow.solid).draw(list.where([&](const DrawItem& one) { return !maps.has_holes(one); }));
                maps.draw(pass, scene, holed, caster_, caster_);
            }};
}

// [record]
void DeferredScene::record(Frame& frame, Scene& scene, const Camera& camera) {
    if (gbuffer.is_forward())
        throw InputError("gbuffer.method forward leaves no surfaces to light afterwards; take another one");
    const std::vector<Batch> batches = scene.all().batches(), glows = glowing(scene, batches);
    const auto surfaces = [&](const SurfacePipelines& by, const std::vector<Batch>& which) {
        return [&](Raster& pass) { maps.draw(pass, scene, which, by.loaded, by.displaced); };
    };
    lights.update(frame, scene, scene.file.lights);
    shadow.record(frame, scene, lights, camera, casters(scene));
    gbuffer.begin(frame);
    frame.raster("gbuffer", {.color = gbuffer.targets(), .depth = frame.depth, .with = {maps, gbuffer}},
                 surfaces(write_, batches));
    gbuffer.written();
    deferred_lights_.record(frame, scene, camera, gbuffer, lights, {lights, shadow, gbuffer});
    if (!glows.empty())
        frame.raster("glow", {.color = {keep(frame.hdr)}, .depth = read_only(frame.depth), .with = {maps}},
                     surfaces(glow_, glows));
}
// [/record]

}  // namespace lightwalk
