// Ray tracing modules: rays through a scene for any query of visibility, and the reference of shadows.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/bvh.h"
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [rays]
/// Gives shaders any_hit() and closest_hit() of 05_shadow_maps/bvh.glsl. record() in each frame that needs it, which
/// builds the hierarchy for a new scene; then passes may state it in `.with`. Every opaque surface stops a ray, from
/// both sides, except in its cut-outs.
struct SceneRays : Module {
    SceneRays(Module& owner, std::string name) : Module(owner, std::move(name), "rays") {}

    bool through_holes = true;  ///< alpha-tested holes let rays through; false: every triangle is solid

    /// Builds the hierarchy and uploads it. Throws InputError where a vertex is no place.
    void build(Gpu& gpu, const Scene& scene);
    void prepare(Gpu&, Scene&) override { built_ = false; }

    /// Builds it after a scene was loaded; if the scene has moved since, the boxes follow. `maps`: maps that cut
    /// holes, with their motion; null: alpha below 0.5, at rest.
    void record(Frame& frame, const Scene& scene, const Maps* maps = nullptr);

    Macros macros() const override;
    std::vector<Resource> reads() const override { return {nodes_, triangles_}; }
    void bind(Pass& pass) const override;

    const Bvh& bvh() const { return bvh_; }
    /// Distance from a surface at which its rays begin, in metres: nearer objects cast no shadow on it.
    float offset_m() const { return state_.offset_m; }
    // [/rays]

    /// The offset as a fraction of the scene's farthest coordinate. Positions come from the rasteriser, which
    /// interpolates between vertices that may be as far: test_ray_offset.cpp measures the need, and this is four
    /// times that.
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

/// Gives shaders lamp_visibility() of 05_shadow_maps/rays.glsl as well: the reference of shadows.
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

    /// For a picture with visibility by rays: the meaning of a non-finite pixel.
    std::string why_not_finite() const;
};

/// The triangles of a scene's opaque items in world space, in the items' order, nothing cut out of them.
std::vector<RayTriangle> ray_triangles(const Scene& scene);

}  // namespace lightwalk
