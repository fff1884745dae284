// Drawing of a scene's objects: this chapter's surfaces under chapter 03's lights.
#pragma once
#include "03_attenuation/lights.h"
#include "04_surface_maps/shading.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [surface_scene]
/// Its modules are the owner's: their options and scene keys are maps.* and lights.*. As scenes of objects have few
/// lights, lights.method is every_light unless something else is said.
struct SurfaceScene : Drawing {
    /// `fragment`: shades them, unless `shading` says otherwise.
    SurfaceScene(Module& owner, std::string name, const char* fragment = "04_surface_maps/lit.frag");

    Maps maps;
    Lights lights;
    Shading shading;
    std::function<LightList(const Frame&)> all_lights;  ///< none given: the scene file's
    std::function<std::vector<Batch>()> drawn;          ///< none given: the scene's opaque items

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override {
        draw_lit(frame, canvas, [&] { lights.record(frame, *scene_, view, canvas.single_depth()); });
    }
    /// Opaque surfaces, lit as they are drawn, into a canvas of any colour format. `sort`: view-dependent state of the
    /// lights, such as their cells; with tiles the canvas has depth by then.
    void draw_lit(Frame& frame, Canvas& canvas, const std::function<void()>& sort);
    std::vector<Transparent> transparent(const View& view) const override;
    std::vector<With> transparent_with() const override { return given(); }
    std::vector<Resource> transparent_reads() const override { return shading.reads; }
    void draw_transparent(Raster& pass, std::span<const Transparent> items) const override;
    std::vector<TransparentTriangle> transparent_triangles(const View& view) const override;
    void draw_transparent_triangles(Raster& pass, uint32_t item, const Buffer& indices, uint32_t first,
                                    uint32_t count) const override;
    // [/surface_scene]

    // For drawings that draw these surfaces in other passes.

    const Module* shadows = nullptr;  ///< shades them as well, if given

    /// The modules that shading reads.
    std::vector<With> given() const;
    /// Draws the opaque surfaces, or some of them, with the given pipelines.
    std::function<void(Raster&)> by(const SurfacePipelines& both) const { return by(both, opaque_batches()); }
    std::function<void(Raster&)> by(const SurfacePipelines& both, std::vector<Batch> batches) const;
    std::vector<Batch> opaque_batches() const;
    const SurfacePipelines& opaque_pipelines() const { return shading.opaque ? *shading.opaque : shade_; }
    const SurfacePipelines& depth_pipelines() const { return shading.depth ? *shading.depth : depth_; }
    const Scene& scene() const { return *scene_; }

  private:
    const SurfacePipelines& transparent_pipelines() const;
    Scene* scene_ = nullptr;
    SurfacePipelines depth_{{.fragment = "04_surface_maps/depth.frag"}};
    SurfacePipelines shade_;
    // Tiles hold the lights of opaque surfaces only.
    SurfacePipelines see_through_, see_through_tiles_;
};

}  // namespace lightwalk
