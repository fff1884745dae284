// Ray tracing modules: rays through a scene for any query of visibility, and the reference of shadows.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/bvh.h"
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// GLSL: any_hit() and closest_hit() of 05_shadow_maps/bvh.glsl. record() in each frame with rays, which builds the
/// hierarchy for a new scene; then passes with the module in `.with`. Opaque surfaces stop rays from both sides, except
/// in their cut-outs.
struct SceneRays : Module {
    SceneRays(Module& owner, std::string name) : Module(owner, std::move(name), "rays") {}

    bool through_holes = true;  ///< alpha-tested holes let rays through; false: every triangle is solid

    /// Builds and uploads the hierarchy. Throws InputError for a vertex that is not finite.
    void build(Gpu& gpu, const Scene& scene);
    void prepare(Gpu&, Scene&) override { built_ = false; }

    /// Builds the hierarchy of a new scene, or refits it to a moved one. `maps`: maps that cut holes, with their
    /// motion; null: alpha below 0.5, at rest.
    void record(Frame& frame, const Scene& scene, const Maps* maps = nullptr);

    Macros macros() const override;
    std::vector<Resource> reads() const override { return {nodes_, triangles_}; }
    void bind(Pass& pass) const override;

    const Bvh& bvh() const { return bvh_; }
    /// Offset of ray origins from the surface, metres; nearer objects cast no shadow on it.
    float offset_m() const { return state_.offset_m; }

    /// Offset as a fraction of the scene's farthest coordinate: the rasteriser interpolates positions between vertices
    /// that may be as far. Four times the need measured by test_ray_offset.cpp.
    static constexpr float offset_share = 0x1p-17f;

  protected:
    RayState state_{.cutoff = 0.5f, .color_cuts = 1, .opacity_cuts = 1};

  private:
    void set_offset();
    Bvh bvh_;
    uint64_t placed_ = 0;
    bool has_cutouts_ = true, built_ = false;
    Buffer nodes_, triangles_, cutouts_, masks_, texels_;
};

/// SceneRays with lamp_visibility() of 05_shadow_maps/rays.glsl, the reference for shadows.
struct Rays : SceneRays {
    using SceneRays::SceneRays;

    Knob<int> truth_samples{*this,
                            "truth_samples",
                            16,
                            {1, 64},
                            "Rays from each pixel to each light with an area; --samples multiplies them"};
    Knob<bool> cutouts{*this, "cutouts", true, "Alpha-tested holes let rays through; off: every triangle is solid"};

    void record(Frame& frame, const Scene& scene, const Maps* maps = nullptr);
    Macros macros() const override;

    /// Cause of a non-finite pixel in a picture with rays.
    std::string why_not_finite() const;
};

/// World-space triangles of opaque items, in the items' order, without cut-outs.
std::vector<RayTriangle> ray_triangles(const Scene& scene);

}  // namespace lightwalk
