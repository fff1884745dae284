// Visibility buffer: which triangle each pixel shows, drawn first, so that compute shaders shade each pixel once.
#pragma once
#include "04_surface_maps/surface_pipelines.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [visibility_buffer]
/// Eight bytes a pixel: an item of the scene, counted from 1, and a triangle of its part. For surfaces of chapter 04 with
/// the mesh as loaded. (C. Burns and W. Hunt, JCGT 2(2), 2013.)
class VisibilityBuffer {
  public:
    /// Whether it can stand in for drawing: not where vertex shaders make triangles, nor for several samples a pixel.
    static bool suits(const Maps& maps, const Canvas& canvas);

    /// Draws the buffer, and depth into the canvas.
    void record(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches, Canvas& canvas);

    /// Colour into the canvas, wherever one of these batches is visible: a dispatch for each, by a pipeline with
    /// 05_shadow_maps/shade_seen.glsl in its shader.
    void shade(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches, Canvas& canvas,
               const Pipeline& pipeline, const std::vector<With>& with, const std::vector<Resource>& reads = {}) const;

    const Image& image() const { return seen_; }

  private:
    Image seen_;
    SurfacePipelines solid_{{.fragment = "05_shadow_maps/visible.frag"}};
    SurfacePipelines holes_{{.fragment = "05_shadow_maps/visible_cutout.frag"}};
};
// [/visibility_buffer]

/// Where opaque surfaces are shaded.
struct ShadedChoice : Choice {
    explicit ShadedChoice(Module& module);
};

/// `image` as a visibility buffer of the canvas's size, cleared to item 0 (none).
Attachment visibility_target(Frame& frame, Image& image, const Canvas& canvas);

}  // namespace lightwalk
