// Layers of the shadow maps: what each of them holds, and which view of the frame reads it.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

namespace lightwalk {

// [map_content]
/// What a shadow map was drawn from.
struct MapContent {
    glm::mat4 view{0.0f};                                 ///< the light's: world to clip space
    std::vector<std::pair<uint32_t, glm::mat4>> casters;  ///< places in Scene::items, and where they stood
    uint64_t others = 0;                                  ///< Shadow::Casters::others_placed
    bool operator==(const MapContent&) const = default;
};

/// The places in Scene::items of what stood elsewhere, or in one of the two alone; ascending, as both are.
std::vector<uint32_t> moved_between(const MapContent& before, const MapContent& now);
/// The content without these items.
MapContent without(MapContent content, const std::vector<uint32_t>& items);
// [/map_content]

// [map_layers]
/// The maps of all views of a frame are layers of one image: what two views want alike, the map of a lamp, is drawn once
/// and read by both.
class MapLayers {
  public:
    /// The layer for each map that view `id` (View::id) wants, instead of those it had. One that holds what is wanted; else
    /// one drawn from the same light's view before something moved, which nobody wants any more; else one that no other
    /// view has; else a new one, while there are fewer than `most`. At most `most` may be wanted.
    std::vector<uint32_t> choose(uint32_t id, const std::vector<const MapContent*>& wanted, uint32_t most);

    struct Layer {
        MapContent content;
        std::vector<uint32_t> moved;  ///< since the same view was drawn before
    };
    /// What was drawn last from the same light's view, if what is wanted is not there.
    const Layer* before(const MapContent& wanted) const;

    /// What the layers hold is of no use any more.
    void forget() { layers_.assign(layers_.size(), {}); }
    /// Nor are the layers.
    void clear() { layers_.clear(), of_view_.clear(); }

    size_t size() const { return layers_.size(); }
    Layer& operator[](uint32_t layer) { return layers_[layer]; }

  private:
    std::vector<Layer> layers_;
    std::map<uint32_t, std::vector<uint32_t>> of_view_;
};
// [/map_layers]

}  // namespace lightwalk
