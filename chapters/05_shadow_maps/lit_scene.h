// Drawing of a scene's objects: chapter 04's surfaces with this chapter's shadows.
#pragma once
#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/shadow.h"
#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

// [lit_scene]
/// SurfaceScene with shadows: beside its modules the owner gets shadow.*.
struct LitScene : SurfaceScene {
    LitScene(Module& owner, std::string name)
        : SurfaceScene(owner, std::move(name), "05_shadow_maps/surface.frag"), shadow(owner, "shadow") {}

    Shadow shadow;
    Choice shaded{
        *this,
        "shaded",
        {"raster", "visibility"},
        "raster",
        "Shading of opaque surfaces: as they are drawn, by fragment shaders (raster), or in compute, once for "
        "each pixel of a visibility buffer"};
    // [/lit_scene]

    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    void record_light(Frame& frame, const View& view, const ImageView& depth = {}) override;
    /// Maps of depth alone, from each light that casts a shadow.
    void record_shadows(Frame& frame, const View& view);

  protected:
    std::vector<With> given() const override;

  private:
    VisibilityBuffer seen_;
    Pipeline shade_seen_ = seen_pipeline("05_shadow_maps/surface_seen.comp");
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
