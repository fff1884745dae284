// Drawing of a scene's objects: this chapter's surfaces under chapter 03's lights.
#pragma once
#include "03_attenuation/lights.h"
#include "04_surface_maps/maps.h"
#include "common/app/drawing.h"
#include "common/app/world.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Pipelines by pass, and their bindings beside the drawing's modules. Null: the drawing's own pipelines.
struct Shading {
    const SurfacePipelines* opaque = nullptr;
    const Pipeline* seen = nullptr;                 ///< opaque surfaces in compute, for chapter 05's visibility buffer
    const SurfacePipelines* transparent = nullptr;  ///< blended surfaces; see see_through()
    const SurfacePipelines* depth = nullptr;        ///< depth only, before lights are sorted into tiles
    /// Chapter 06's G-buffer: `stored` writes it, `rest` adds light other than the lights', with emission and ambient
    /// light.
    const SurfacePipelines* stored = nullptr;
    const SurfacePipelines* rest = nullptr;
    std::vector<With> with{};
    std::vector<Resource> reads{};
};

/// Pipelines for Shading::transparent: the fragment shader with TRANSPARENT, which writes alpha and cuts no holes.
SurfacePipelines see_through(const char* fragment, Macros macros = {});

/// Members have the owner's path: options and scene keys are maps.* and lights.*. lights.method defaults to
/// every_light, since scenes of objects have few lights.
struct SurfaceScene : Drawing, TransparentSource {
    /// `fragment`: fragment shader, unless `shading` has another.
    SurfaceScene(Module& owner, std::string name, const char* fragment = "04_surface_maps/lit.frag");

    Maps maps;
    Lights lights;
    Shading shading;
    std::function<LightList(const Frame&)> all_lights;  ///< default: the scene file's
    std::function<std::vector<Batch>()> drawn;          ///< default: the scene's opaque items

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override {
        draw_lit(frame, canvas, [&] { lights.record(frame, *scene_, view, canvas.single_depth()); });
    }
    /// Forward shading of opaque surfaces into a canvas of any colour format. `sort`: records view-dependent state,
    /// such as light cells; with tiles the canvas then has depth.
    void draw_lit(Frame& frame, Canvas& canvas, const std::function<void()>& sort);
    const TransparentSource* transparent_source() const override { return this; }
    std::vector<Transparent> transparent(const View& view) const override;
    std::vector<With> transparent_with() const override { return given(); }
    std::vector<Resource> transparent_reads() const override { return shading.reads; }
    void draw_transparent(Raster& pass, std::span<const Transparent> items) const override;
    std::vector<TransparentTriangle> transparent_triangles(const View& view) const override;
    void draw_transparent_triangles(Raster& pass, uint32_t item, const Buffer& indices, uint32_t first,
                                    uint32_t count) const override;

    // Parts for drawings with passes of their own.

    const Module* shadows = nullptr;  ///< shadow module, optional

    /// Modules of the shading passes.
    std::vector<With> given() const;
    /// Draws opaque surfaces, or some of them, with these pipelines.
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

struct Surfaces : World {
    explicit Surfaces(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }
    SurfaceScene objects{*this, "objects"};

    Drawings drawings() override { return {objects}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"post.tone", "off"}}; }
};

}  // namespace lightwalk
