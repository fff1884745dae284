// Drawing of a scene's objects that writes surfaces to a G-buffer first and lights them afterwards.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "06_deferred/culling.h"
#include "06_deferred/deferred_lights.h"
#include "common/base/epoch.h"
#include "common/image/image.h"

namespace lightwalk {

// [deferred_scene]
/// LitScene through a G-buffer, or as LitScene draws it where gbuffer.method is forward. Surfaces that a G-buffer has no
/// room for (unlit ones, and microfacets unless all are) and transparent ones are drawn as LitScene draws them.
struct DeferredScene : Drawing, ItemCaster {
    DeferredScene(Module& owner, std::string name, std::optional<Shading> fixed = std::nullopt);

    LitScene lit;
    SurfaceScene& surfaces = lit.surfaces;
    Maps& maps = lit.maps;
    Lights& lights = lit.lights;
    Shadow& shadow = lit.shadow;
    Shading& shading = lit.shading;
    GBuffer gbuffer;
    Culling culling;

    int times = 1;             ///< how often every surface is drawn
    bool depth_first = false;  ///< depth alone before, so that each pixel is written once
    enum class Cull {
        fixed,
        geometry,
        nothing,
        left_out
    } cull = Cull::fixed;  ///< of triangles that face away, from the G-buffer

    void find_casters(const Drawings& drawings) override { lit.find_casters(drawings); }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override { lit.update_once(frame); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    /// The opaque objects of the last draw(), after culling, from another view.
    void draw_kept(Frame& frame, const View& view, Canvas& canvas);
    /// None if a channel of the G-buffer is shown.
    const Drawing* transparent_source() const override { return gbuffer.show.is("picture") ? &surfaces : nullptr; }
    const Maps& cut_by() const override { return maps; }
    // [/deferred_scene]

    /// For Shading::rest: added to the light in a pixel.
    static SurfacePipelines added(const char* fragment, Macros macros = {});

  private:
    void draw_alone(Frame& frame, const View& view, Canvas& canvas);
    void draw_forward(Frame& frame, const View& view, Canvas& canvas);
    void write_gbuffer(Frame& frame, Canvas& canvas);
    void add_rest(Frame& frame, Canvas& canvas);
    void draw_lit(Frame& frame, const View& view, Canvas& canvas, const std::string& name,
                  const std::vector<Batch>& batches);
    /// The opaque surfaces that the G-buffer holds, or the others.
    std::vector<Batch> batches_by_stored(bool stored) const;
    std::function<void(Raster&)> often_by(const SurfacePipelines& both, std::vector<Batch> batches) const;
    void draw_kept(Raster& pass, const SurfacePipelines& both, const std::vector<Batch>& batches) const;
    std::vector<With> with(std::vector<With> modules) const;
    bool emits();  ///< any opaque item
    const Scene& scene() const { return surfaces.scene(); }

    DeferredLights deferred_lights_;
    Image own_color_, own_depth_;  ///< where others have drawn before
    Pipeline merge_ =
        graphics({.vertex = "06_deferred/whole.vert", .fragment = "06_deferred/merge.frag", .cull = VK_CULL_MODE_NONE});
    SurfacePipelines lost_{{.fragment = "06_deferred/lost.frag"}};
    SurfacePipelines write_{{.fragment = "06_deferred/write.frag"}};
    SurfacePipelines write_all_{{.fragment = "06_deferred/write.frag", .cull = VK_CULL_MODE_NONE}};
    SurfacePipelines write_culled_{
        {.geometry = "06_deferred/cull.geom", .fragment = "06_deferred/write.frag", .cull = VK_CULL_MODE_NONE}};
    SurfacePipelines write_left_out_{{.geometry = "06_deferred/cull.geom",
                                      .fragment = "06_deferred/write.frag",
                                      .cull = VK_CULL_MODE_NONE,
                                      .macros = {{"LEFT_OUT", "1"}}}};
    Fingerprint emission_sought_;
    bool emits_ = false;
    SurfacePipelines emission_ = added("06_deferred/emission.frag");
    /// Depths behind a geometry shader may differ in the last bit from those without.
    SurfacePipelines emission_culled_{{.geometry = "06_deferred/cull.geom",
                                       .fragment = "06_deferred/emission.frag",
                                       .cull = VK_CULL_MODE_NONE,
                                       .depth_write = false,
                                       .blend = Blend::add}};
};

/// The batches that contain emissive items.
std::vector<Batch> emitting(const Scene& scene, const std::vector<Batch>& batches);

/// From a picture of the G-buffer's losses: degrees of normals, millimetres of positions, on average over the drawn
/// pixels.
glm::vec2 mean_loss(const ImageRgb& picture);

}  // namespace lightwalk
