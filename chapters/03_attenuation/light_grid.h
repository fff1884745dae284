// Grid of cells over the screen, with the lights of each cell, built on the GPU.
#pragma once
#include "03_attenuation/light_buffer.h"
#include "03_attenuation/light_data.h"
#include "common/gpu/frame.h"
#include "common/scene/mesh.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Sides of a tile and, for clusters, of a column of them, in pixels, unless that makes a buffer too large.
constexpr uint32_t tile_px = 16, cluster_px = 64;

/// Depth range of the clusters in metres: the part of the box `scene` in front of the camera. The near depth is below
/// the far one, and at least a 500th of it.
glm::vec2 cluster_depths(const Camera& camera, const Bounds& scene);

// [light_grid]
/// Which lights may reach which cell, a bit each: there is one for every pair, so that no list can overflow.
class LightGrid {
  public:
    enum class Cells { tiles, clusters };

    /// Makes the cells of `seen`. Clusters have `slices` over the depth range of `scene` (world space, may be empty);
    /// tiles have none. `threshold`: see influence_radius(). Tiles grow if the bits exceed the largest buffer that every device has.
    void set_view(const View& seen, const Bounds& scene, Cells cells, int slices, size_t lights, float threshold);

    /// Sorts the lights into the cells, for tiles by the view's `depth`. `lights` gives shaders the lights' buffer and
    /// this grid's view.
    void record(Frame& frame, const PassInputs& lights, const ImageView& depth);

    Buffer masks, groups;  ///< layout in light_data.h
    GridView view;

  private:
    uint32_t cell_count() const { return view.tiles.x * view.tiles.y * view.slices; }
    VkDeviceSize mask_words() const {
        return VkDeviceSize((lights_ + LIGHTS_PER_MASK - 1) / LIGHTS_PER_MASK) * cell_count();
    }
    Cells cells_ = Cells::tiles;
    size_t lights_ = 0;
    Pipeline cull_tiles_ = compute({.shader = "03_attenuation/cull_tiles.comp"});
    Pipeline cull_lights_ = compute({.shader = "03_attenuation/cull_lights.comp"});
};
// [/light_grid]

}  // namespace lightwalk
