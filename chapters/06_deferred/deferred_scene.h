// Drawing of a scene's objects that writes surfaces to a G-buffer first and lights them afterwards.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "06_deferred/culling.h"
#include "06_deferred/deferred_lights.h"
#include "common/base/epoch.h"
#include "common/image/image.h"

namespace lightwalk {

/// LitScene through a G-buffer, or forward if gbuffer.method says so. Transparent surfaces, and those the G-buffer
/// cannot hold (unlit ones, and microfacets unless all are), are shaded forward.
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

    DeferredLights deferred;

    void find_casters(const Drawings& drawings) override { lit.find_casters(drawings); }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override { lit.update_once(frame); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    /// Opaque objects of the last draw(), after culling, from another view.
    void draw_kept(Frame& frame, const View& view, Canvas& canvas);
    /// Null if a channel of the G-buffer is shown.
    const TransparentSource* transparent_source() const override {
        return gbuffer.show.is("picture") ? &surfaces : nullptr;
    }
    const Maps& cut_by() const override { return maps; }

    // Parts for chapters that record the passes themselves.

    /// `modules`, the shading's modules, and culling.
    std::vector<With> with(std::vector<With> modules) const;
    /// Opaque batches that the G-buffer holds, or the others.
    std::vector<Batch> batches_by_stored(bool stored) const;
    /// Draws the batches, after culling.
    std::function<void(Raster&)> by(const SurfacePipelines& both, std::vector<Batch> batches) const;
    void draw_forward(Frame& frame, const View& view, Canvas& canvas, const std::vector<Batch>& batches);
    /// Emission, or Shading::rest, of the surfaces in the G-buffer; false if none emits.
    bool write_emission(Frame& frame, Canvas& canvas, const SurfacePipelines& emission);
    /// Forward pass over some batches, with light lists for their own depths.
    void draw_lit(Frame& frame, const View& view, Canvas& canvas, const std::string& name,
                  const std::vector<Batch>& batches);
    const SurfacePipelines& emission() const { return emission_; }
    const SurfacePipelines& written() const { return shading.stored ? *shading.stored : write_; }

  private:
    void draw_alone(Frame& frame, const View& view, Canvas& canvas);
    bool emits();  ///< whether any opaque item is emissive
    const Scene& scene() const { return surfaces.scene(); }

    Image own_color_, own_depth_;  ///< used if earlier drawings have filled the canvas
    Pipeline merge_ =
        graphics({.vertex = "06_deferred/whole.vert", .fragment = "06_deferred/merge.frag", .cull = VK_CULL_MODE_NONE});
    SurfacePipelines lost_{{.fragment = "06_deferred/lost.frag"}};
    SurfacePipelines write_{{.fragment = "06_deferred/write.frag"}};
    Fingerprint emission_sought_;
    bool emits_ = false;
    SurfacePipelines emission_{{.fragment = "06_deferred/emission.frag", .depth_write = false}};
};

/// Batches with emissive items.
std::vector<Batch> emitting(const Scene& scene, const std::vector<Batch>& batches);

/// Mean encoding error over the drawn pixels: degrees of normals, millimetres of positions.
glm::vec2 mean_loss(const ImageRgb& picture);

}  // namespace lightwalk
