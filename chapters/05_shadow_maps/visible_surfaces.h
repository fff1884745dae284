// Drawing of chapter 04's surfaces, without shadows, that can be shaded in compute.
#pragma once
#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

/// Draws the surfaces of a SurfaceScene, as it would itself or over a visibility buffer. Both have the same owner and name.
struct VisibleSurfaces : Drawing {
    VisibleSurfaces(Module& owner, std::string name, SurfaceScene& scene_surfaces)
        : Drawing(owner, std::move(name)), surfaces(scene_surfaces) {}

    SurfaceScene& surfaces;
    ShadedChoice shaded{*this};

    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override { surfaces.update_once(frame); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    const Drawing* transparent_source() const override { return &surfaces; }

  private:
    VisibilityBuffer seen_;
    Pipeline shade_seen_ = compute({.shader = "05_shadow_maps/lit_seen.comp"});
};

}  // namespace lightwalk
