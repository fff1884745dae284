// Drawing of a scene's objects: chapter 04's surfaces with this chapter's shadows.
#pragma once
#include <optional>

#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/casting.h"
#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

/// SurfaceScene with shadows. Adds shadow.* to the owner's options, and the choice between raster and compute shading
/// unless a fixed shading has only fragment shaders.
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
    const TransparentSource* transparent_source() const override { return &surfaces; }
    const Maps& cut_by() const override { return maps; }

    /// Forward shading of opaque surfaces into a canvas of any colour format.
    void draw_lit(Frame& frame, const View& view, Canvas& canvas);
    /// Shadow maps of the view.
    void record_shadows(Frame& frame, const View& view) {
        shadow.record(frame, surfaces.scene(), lights, view, casters(frame));
    }
    /// Objects that cast shadows, with the pipelines that draw them into a map.
    Shadow::Casters casters(const Frame& frame) const;

    /// Whether draw_visible() shades opaque surfaces, in compute over a visibility buffer. `sort`: records light lists,
    /// once the canvas has depth.
    bool shades_in_compute(const Canvas& canvas) const;
    void draw_visible(Frame& frame, Canvas& canvas, const std::function<void()>& sort, const std::vector<Batch>& drawn);
    VisibilityBuffer visible;
    /// Pipeline that shades the pixels of `visible`.
    const Pipeline& compute_pipeline() const { return shading.seen ? *shading.seen : shade_seen_; }

  private:
    std::optional<ShadedChoice> shaded_;
    Casting casting_;
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
