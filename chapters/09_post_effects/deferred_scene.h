// A scene through chapters 03 to 06: maps, lights, shadows, a G-buffer, light on it.
#pragma once
#include "05_shadow_maps/shadow.h"
#include "06_deferred/deferred_lights.h"
#include "06_deferred/surfaces.h"

namespace lightwalk {

// [deferred_scene]
/// prepare() when a scene was loaded; then, in a frame whose `view` is set, record() into frame.hdr and frame.depth.
struct DeferredScene : Module {
    DeferredScene(Module& owner, std::string name);

    Maps maps;
    Lights lights;
    Shadow shadow;
    GBuffer gbuffer;

    void prepare(Gpu& gpu, Scene& scene);
    void record(Frame& frame, Scene& scene, const Camera& camera);
    // [/deferred_scene]

  private:
    Shadow::Casters casters(const Scene& scene) const;
    SurfacePipelines write_{{.fragment = "06_deferred/write.frag"}};
    // A little nearer: with other outputs a device may compute the last bit of depth otherwise.
    SurfacePipelines glow_{{.fragment = "06_deferred/glow.frag",
                            .depth_write = false,
                            .depth_bias = {.constant = 16},
                            .blend = Blend::add}};
    Pipeline caster_ = graphics({.vertex = "04_surface_maps/surface.vert",
                                 .fragment = "04_surface_maps/depth.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_clamp = true});
    DeferredLights deferred_lights_;
};

}  // namespace lightwalk
