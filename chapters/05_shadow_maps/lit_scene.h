// Drawing of a scene's objects: chapter 04's surfaces with this chapter's shadows.
#pragma once
#include <optional>

#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/casting.h"
#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

// [lit_scene]
/// SurfaceScene with shadows: beside its modules the owner gets shadow.*, and the choice of where opaque surfaces are
/// shaded, unless the shading is fixed and has fragment shaders alone.
struct LitScene : Drawing, ItemCaster {
    LitScene(Module& owner, std::string name, std::optional<Shading> fixed = std::nullopt);

    SurfaceScene surfaces;
    Maps& maps = surfaces.maps;
    Lights& lights = surfaces.lights;
    Shading& shading = surfaces.shading;
    Shadow shadow;

    void find_casters(const Drawings& drawings) override { casting_ = Casting(drawings); }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override { surfaces.update_once(frame); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    const Drawing* transparent_source() const override { return &surfaces; }
    const Maps& cut_by() const override { return maps; }

    /// Opaque surfaces, lit as they are drawn, into a canvas of any colour format.
    void draw_lit(Frame& frame, const View& view, Canvas& canvas);
    /// Maps of depth alone, from each light that casts a shadow.
    void record_shadows(Frame& frame, const View& view);
    // [/lit_scene]

    /// Whether surfaces are shaded in compute, over a visibility buffer, as draw_visible() does. `sort` sorts the lights, when
    /// there is a depth; every surface is drawn so many times.
    bool shades_in_compute(const Canvas& canvas) const;
    void draw_visible(Frame& frame, Canvas& canvas, const std::function<void()>& sort, int times = 1);

  private:
    std::optional<ShadedChoice> shaded_;
    Casting casting_;
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
