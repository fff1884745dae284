// Visibility buffer: which triangle each pixel shows, drawn first, so that compute shaders shade each pixel once.
#pragma once
#include "04_surface_maps/maps.h"
#include "04_surface_maps/surface_scene.h"
#include "common/app/drawing.h"

namespace lightwalk {

/// Eight bytes a pixel: scene item, counted from 1, and triangle of its part, for meshes as loaded (C. Burns and W.
/// Hunt, JCGT 2(2), 2013).
class VisibilityBuffer {
  public:
    VisibilityBuffer();

    /// Whether it can replace raster shading: not for displaced meshes or several samples a pixel.
    static bool suits(const Maps& maps, const Canvas& canvas);

    /// Draws the buffer, and the canvas's depth.
    void record(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches, Canvas& canvas);

    /// Shades the canvas where these batches are visible, one dispatch each, by a pipeline with
    /// 05_shadow_maps/shade_seen.glsl.
    void shade(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches, Canvas& canvas,
               const Pipeline& pipeline, const std::vector<With>& with, const std::vector<Resource>& reads = {}) const;

    const Image& image() const { return seen_; }

  private:
    Image seen_;
    SurfacePipelines solid_{{.fragment = "05_shadow_maps/visible.frag"}};
    SurfacePipelines holes_{{.fragment = "05_shadow_maps/visible_cutout.frag"}};
};

/// Choice between raster and compute shading of opaque surfaces.
struct ShadedChoice : Choice {
    explicit ShadedChoice(Module& module);
};

/// Target for a visibility buffer of the canvas's size, cleared to item 0 (none).
Attachment visibility_target(Frame& frame, Image& image, const Canvas& canvas);

/// Surfaces of a SurfaceScene with the same owner and name, by raster or over a visibility buffer.
struct VisibleSurfaces : Drawing {
    VisibleSurfaces(Module& owner, std::string name, SurfaceScene& scene_surfaces)
        : Drawing(owner, std::move(name)), surfaces(scene_surfaces) {}

    SurfaceScene& surfaces;
    ShadedChoice shaded{*this};

    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override { surfaces.update_once(frame); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    const TransparentSource* transparent_source() const override { return &surfaces; }

  private:
    VisibilityBuffer seen_;
    Pipeline shade_seen_ = compute({.shader = "05_shadow_maps/lit_seen.comp"});
};

}  // namespace lightwalk
