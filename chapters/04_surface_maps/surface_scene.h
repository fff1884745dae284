// Drawing of a scene's objects: this chapter's surfaces under chapter 03's lights.
#pragma once
#include "03_attenuation/lights.h"
#include "04_surface_maps/surface_pipelines.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [surface_scene]
/// Its modules are the owner's: their options and scene keys are maps.* and lights.*. As scenes of objects have few
/// lights, lights.method is every_light unless something else is said.
struct SurfaceScene : Drawing {
    SurfaceScene(Module& owner, std::string name);

    Maps maps;
    Lights lights;

    /// Parts that differ from chapter to chapter.
    std::function<std::vector<Light>(const Frame&)> all_lights;  ///< none given: the scene file's
    std::function<std::vector<Batch>()> surfaces;                ///< default: the scene's opaque items
    const SurfacePipelines* shading = nullptr;                   ///< null: the drawing's own
    const SurfacePipelines* transparent_shading = nullptr;       ///< the same with blending
    std::vector<With> shading_with;                              ///< further modules that these need
    std::vector<Resource> shading_reads;                         ///< and images

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    std::vector<const Module*> made_of() const override;
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override { draw_lit(frame, view, canvas); }
    /// Opaque surfaces, lit as they are drawn, into a canvas of any colour format.
    void draw_lit(Frame& frame, const View& view, Canvas& canvas);
    /// View-dependent state of the lights, such as their cells. `depth`: the view's, for tiles.
    virtual void record_light(Frame& frame, const View& view, const ImageView& depth = {});
    std::vector<Transparent> transparent(const View& view) const override;
    std::vector<With> transparent_with() const override { return given(); }
    std::vector<Resource> transparent_reads() const override { return shading_reads; }
    void draw_transparent(Raster& pass, std::span<const Transparent> items) const override;
    std::vector<TransparentTriangle> transparent_triangles(const View& view) const override;
    void draw_transparent_triangles(Raster& pass, uint32_t item, const Buffer& indices, uint32_t first,
                                    uint32_t count) const override;
    // [/surface_scene]

    /// For transparent_shading: the fragment shader with TRANSPARENT, which writes alpha and cuts nothing out.
    static SurfacePipelines see_through(const char* fragment, Macros macros);

  protected:
    /// With the fragment shader that shades them.
    SurfaceScene(Module& owner, std::string name, const char* fragment);

    /// The modules that shading reads.
    virtual std::vector<With> given() const;

    /// Draws the opaque surfaces, or some of them, with the given pipelines.
    std::function<void(Raster&)> by(const SurfacePipelines& both) const { return by(both, opaque_batches()); }
    std::function<void(Raster&)> by(const SurfacePipelines& both, std::vector<Batch> batches) const;
    std::vector<Batch> opaque_batches() const;

    Scene* scene_ = nullptr;
    SurfacePipelines depth_{{.fragment = "04_surface_maps/depth.frag"}};
    SurfacePipelines shade_;

  private:
    const SurfacePipelines& see_through_pipelines() const;
    // Tiles hold the lights of opaque surfaces only.
    SurfacePipelines see_through_, see_through_tiles_;
};

}  // namespace lightwalk
