#include "13_mlaa/other_pictures.h"

namespace lightwalk {

OtherPictures::OtherPictures(Module& chapter)
    : julia(chapter, "julia"),
      terrain(chapter, "terrain"),
      skin(chapter, "skin"),
      rays(chapter, "rays"),
      environment(chapter, "environment") {}

void OtherPictures::prepare_head(Gpu& gpu, const Scene& scene) {
    skin.prepare(gpu, scene);
    rays.prepare(gpu, scene);
}

void OtherPictures::draw_julia(Frame& frame, const Scene& scene, const Camera& camera) {
    environment.record(frame, scene);
    julia.record(frame, scene, camera, environment);
}

void OtherPictures::draw_terrain(Frame& frame, const Scene& scene, const Camera& camera) {
    terrain.prepare(frame.gpu);
    terrain.record(frame, scene, camera);
}

void OtherPictures::draw_head(Frame& frame, const Scene& scene, const Camera& camera, const Lit& lit) {
    lit.lights.record(frame, scene, camera);
    lit.shadow.record(frame, scene, lit.lights, camera);
    rays.record(frame, scene);
    environment.record(frame, scene);
    const Skin::Lit by{lit.maps, rays, {lit.lights, lit.shadow, environment}};
    skin.record(frame, scene, camera, by);
    frame.compute("backdrop", {.writes = {frame.hdr}, .with = {environment}}, [&](Compute& pass) {
        pass.use(backdrop_).set("backdrop", 4.5f).set("result", frame.hdr).dispatch_threads(frame.size);
    });
    skin.draw(frame, scene, by);
    skin.finish(frame, camera);
}

}  // namespace lightwalk
