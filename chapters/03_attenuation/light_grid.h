// Grid of cells over the screen, with the lights of each cell, built on the GPU.
#pragma once
#include "03_attenuation/light_buffer.h"
#include "03_attenuation/light_data.h"
#include "common/gpu/frame.h"
#include "common/scene/mesh.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Widths of a tile, and of a column of clusters, in pixels; larger if a buffer would exceed its limit.
constexpr uint32_t tile_px = 16, cluster_px = 64;

/// Depth range of clusters in metres: the part of the box `scene` in front of the camera. near < far, and near >= far /
/// 500.
glm::vec2 cluster_depths(const Camera& camera, const Bounds& scene);

// [light_grid]
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
// [/light_grid]

}  // namespace lightwalk
