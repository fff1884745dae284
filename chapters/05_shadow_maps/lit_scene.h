// Drawing of a scene's objects: chapter 04's surfaces with this chapter's shadows.
#pragma once
#include <functional>
#include <optional>

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
    /// Whoever gives a `shading` for good resets it: that is a fragment shader, and there is no choice.
    std::optional<Choice> shaded{
        std::in_place,
        *this,
        "shaded",
        std::vector<std::string>{"raster", "visibility"},
        "raster",
        "Shading of opaque surfaces without a G-buffer: as they are drawn, by fragment shaders (raster), or in "
        "compute, once for each pixel of a visibility buffer; raster for displaced meshes and for several samples per "
        "pixel"};
    // [/lit_scene]

    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    void record_light(Frame& frame, const View& view, const ImageView& depth = {}) override;
    /// Maps of depth alone, from each light that casts a shadow.
    void record_shadows(Frame& frame, const View& view);

  protected:
    std::vector<With> given() const override;

    /// Whether surfaces are shaded in compute, over a visibility buffer, as draw_seen() does. `cells` sorts the lights, when
    /// there is a depth; every surface is drawn so many times.
    bool shades_seen(const Canvas& canvas) const;
    void draw_seen(Frame& frame, Canvas& canvas, const std::function<void()>& cells, int times = 1);

  private:
    VisibilityBuffer seen_;
    Pipeline shade_seen_ = compute({.shader = "05_shadow_maps/surface_seen.comp"});
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
