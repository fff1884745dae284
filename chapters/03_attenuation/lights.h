// Lights module: a scene's lights in a buffer, their lists for each draw call, and a grid of them over the screen.
#pragma once
#include "03_attenuation/light_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/light.h"
#include "common/scene/mesh.h"
#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Widths of a tile, and of a column of clusters, in pixels; larger if a buffer would exceed its limit.
constexpr uint32_t tile_px = 16, cluster_px = 64;

/// Depth range of clusters in metres: the part of the box `scene` in front of the camera. near < far, and near >= far /
/// 500.
glm::vec2 cluster_depths(const Camera& camera, const Bounds& scene);

/// Bit for each pair of light and cell, so that no list can overflow.
class LightGrid {
  public:
    enum class Cells { tiles, clusters };

    /// Cells of `seen`. Clusters have `slices` over the depth range of `scene` (world space, may be empty); tiles have
    /// none. `threshold`: see influence_radius(). Tiles grow if the bits exceed the largest buffer that every device
    /// has.
    void set_view(const View& seen, const Bounds& scene, Cells cells, int slices, size_t lights, float threshold);

    /// Fills the cells' bits; tiles use the view's `depth`. `lights` binds the light buffer and this grid's view.
    void record(Frame& frame, const PassInputs& lights, const ImageView& depth);

    /// Allocates the bits of all cells.
    void reserve_masks(Device& device);
    Buffer masks, groups;  ///< layout in light_data.h
    GridView view;
    uint32_t cell_count() const { return view.tiles.x * view.tiles.y * view.slices; }
    uint32_t group_count() const { return uint32_t((lights_ + LIGHTS_PER_GROUP - 1) / LIGHTS_PER_GROUP); }
    Pipeline cull_tiles = compute({.shader = "03_attenuation/cull_tiles.comp"});
    Pipeline cull_clusters = compute({.shader = "03_attenuation/cull_lights.comp"});

  private:
    VkDeviceSize mask_words() const {
        return VkDeviceSize((lights_ + LIGHTS_PER_MASK - 1) / LIGHTS_PER_MASK) * cell_count();
    }
    Cells cells_ = Cells::tiles;
    size_t lights_ = 0;
};

LightData pack(const Light& light);

/// Lights in the scene's order, packed and uploaded again when one has changed.
class LightBuffer {
  public:
    /// Uploads the lights if they have changed; true if so.
    bool update(Frame& frame, const LightList& lights);
    bool update(Frame& frame, const std::vector<Light>& lights);

    Buffer buffer;     ///< bound as `lights`; empty before update()
    int rebuilds = 0;  ///< number of times packed
    const std::vector<Light>& lights() const { return *lights_; }
    const LightList& list() const { return lights_; }  ///< replaced after each change

  private:
    LightList lights_ = std::make_shared<std::vector<Light>>();
};

/// Light lists of draw calls, built on the CPU. Independent of the camera; rebuilt if the lights, the scene's parts,
/// the threshold or the exercise's toggle change.
class ObjectLights {
  public:
    /// `threshold`: see influence_radius(). Uploads new lists.
    void update(Frame& frame, const Scene& scene, const LightBuffer& lights, float threshold);

    Buffer ends;    ///< end of each draw call's list in `lights`
    Buffer lights;  ///< indices into the LightBuffer, ascending in each list

  private:
    Fingerprint made_;
};

/// GLSL: light_surface() of 03_attenuation/lighting.glsl. Per frame: update(); the scene's depth if needs_depth();
/// record() for a view; then passes of this view with the module in `.with`.
struct Lights : Module {
    Lights(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"every_light", "per_object", "tiled", "clustered"},
                  "clustered",
                  "Light culling: all lights (every_light), or those that may reach the pixel's object (per_object), "
                  "screen tile (tiled) or cluster (clustered)"};
    Choice falloff{
        *this,
        "falloff",
        {"range_fade", "inverse_square_window", "inverse_square"},
        "inverse_square_window",
        "Distance attenuation: range_fade, inverse_square_window (0 at the range), or inverse_square (never 0)"};
    Knob<float> fade_k{
        *this, "fade_k", 1.0f, {0.0f, 100.0f}, "Constant k of range_fade, the quadratic term of its denominator",
        "1/m²"};
    Knob<float> threshold{*this,
                          "threshold",
                          0.004f,
                          {1e-6f, 1.0f},
                          "Radiance below which culling treats an inverse_square light as ended"};
    Knob<int> slices{*this, "slices", 24, {1, 256}, "Number of depth slices, and so of clusters, in each tile"};

    /// Uploads the lights and each object's list if they have changed.
    void update(Frame& frame, const Scene& scene, const LightList& lights);
    void update(Frame& frame, const Scene& scene, const std::vector<Light>& lights);

    /// Whether record() reads the view's depth.
    bool needs_depth() const { return method.is("tiled"); }

    /// Lays out the view's tiles or clusters, still without lights.
    void set_cells(Frame& frame, const Scene& scene, const View& view);
    bool has_cells() const { return method.is("tiled") || method.is("clustered"); }

    /// set_cells(), then the lights of each cell. `depth`: the view's, where needs_depth().
    void record(Frame& frame, const Scene& scene, const View& view, const ImageView& depth = {});

    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    const LightBuffer& buffer() const { return buffer_; }
    LightGrid grid;
    std::vector<std::string> status() const override;

    /// Culling radius of a point or spot light, in metres.
    float reach_m(const Light& light) const { return influence_radius(pack(light), ends_at()); }

  private:
    void update_objects(Frame& frame, const Scene& scene);
    float ends_at() const { return falloff.is("inverse_square") ? threshold : 0.0f; }
    LightBuffer buffer_;
    ObjectLights object_lights_;
};

}  // namespace lightwalk
