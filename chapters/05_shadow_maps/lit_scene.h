// Drawing of a scene's objects: chapter 04's surfaces with this chapter's shadows.
#pragma once
#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/shadow.h"

namespace lightwalk {

// [lit_scene]
/// SurfaceScene with shadows: beside its modules the owner gets shadow.*.
struct LitScene : SurfaceScene {
    LitScene(Module& owner, std::string name)
        : SurfaceScene(owner, std::move(name), "05_shadow_maps/surface.frag"), shadow(owner, "shadow") {}

    Shadow shadow;
    // [/lit_scene]

    void record_light(Frame& frame, const View& view, const ImageView& depth = {}) override;
    /// Maps of depth alone, from each light that casts a shadow.
    void record_shadows(Frame& frame, const View& view);

  protected:
    std::vector<With> given() const override;

  private:
    Pipeline caster_ = graphics({.vertex = "04_surface_maps/surface.vert",
                                 .fragment = "04_surface_maps/depth.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_clamp = true});
    SurfacePipelines first_{{.fragment = "05_shadow_maps/passed.frag",
                             .depth_clamp = true,
                             .macros = {{"TRANSPARENT", "1"}, {"FIRST", "1"}}}};
    SurfacePipelines passed_{{.fragment = "05_shadow_maps/passed.frag",
                              .depth_write = false,
                              .depth_clamp = true,
                              .blend = {Blend::multiply, Blend::minimum},
                              .macros = {{"TRANSPARENT", "1"}}}};
};

}  // namespace lightwalk
