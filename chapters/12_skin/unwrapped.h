// Surface unwrapped to its texture coordinates: positions, normals and stretch.
#pragma once
#include <string>

#include "04_surface_maps/maps.h"
#include "05_shadow_maps/rays.h"
#include "common/base/epoch.h"

namespace lightwalk {

// [unwrapped]
/// Position and contents of each texel of a square map over one item of a scene. Charts, the connected pieces of the
/// layout, are numbered and grow by two texels. Unused texels have a position with w = 0.
class Unwrapped {
  public:
    Image position;   ///< metres, world space; w: the chart, from 1
    Image normal;     ///< unit length, world space; w: roughness
    Image albedo;     ///< linear; w: scale of the specular reflection
    Image stretch;    ///< texels per mm along u and v, mm² of the texel, curvature in 1/mm
    Image occlusion;  ///< x: share of the sky that is seen, 0 to 1; none before trace_sky()

    /// Records it where size (texels of a side), item or placement have changed; true if so.
    bool record(Frame& frame, const Scene& scene, const Maps& maps, const DrawItem& item, uint32_t size);

    /// Ambient occlusion by rays from each texel; slow, and to be done once.
    void trace_sky(Frame& frame, const SceneRays& rays, uint32_t rays_per_texel);

    void forget() { made_.forget(); }

  private:
    Fingerprint made_;
    Image raw_position_, raw_normal_, raw_albedo_, raw_stretch_, noisy_;
    Pipeline unwrap_ = graphics({.vertex = "12_skin/unwrap.vert",
                                 .fragment = "12_skin/unwrap.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_test = false,
                                 .depth_write = false});
    Pipeline dilate_ = compute({.shader = "12_skin/dilate.comp"});
    Pipeline stretch_ = compute({.shader = "12_skin/stretch.comp"});
    Pipeline occlusion_ = compute({.shader = "12_skin/occlusion.comp"});
    Pipeline smooth_ = compute({.shader = "12_skin/smooth_occlusion.comp"});
};
// [/unwrapped]

/// For each vertex of a mesh the number of its chart, from 0: vertices that triangles connect have one.
std::vector<uint32_t> charts_of(const Mesh& mesh);

/// How many mm of the item's surface a unit of its texture coordinates is: the root of the areas' ratio; 0 for none.
double mm_per_uv(const DrawItem& item);

/// Gives every model of the scene its charts, as the vertex attribute `charts`. After Maps::prepare().
void add_charts(Gpu& gpu, const Scene& scene);

}  // namespace lightwalk
