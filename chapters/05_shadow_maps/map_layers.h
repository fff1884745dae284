// Layers of the shadow maps: their contents, and the views that read them.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

namespace lightwalk {

// [map_content]
/// The inputs of a shadow map.
struct MapContent {
    glm::mat4 view{0.0f};                                 ///< the light's: world to clip space
    std::vector<std::pair<uint32_t, glm::mat4>> casters;  ///< places in Scene::items, and where they stood
    uint64_t others = 0;                                  ///< Shadow::Casters::others_placed
    mutable uint64_t number = 0;  ///< of contents that were found to be equal, which are not compared again; 0: none
    bool operator==(const MapContent& other) const;
};

/// Indices in Scene::items of moved items, or of items in only one of the two; ascending, as both are.
std::vector<uint32_t> moved_between(const MapContent& before, const MapContent& now);
/// The content without these items.
MapContent without(MapContent content, const std::vector<uint32_t>& items);
// [/map_content]

// [map_layers]
/// The maps of all views of a frame are layers of one image: a map wanted by two views, such as a lamp's, is drawn
/// once and read by both.
class MapLayers {
  public:
    /// The layer for each map wanted by view `id` (View::id), instead of its earlier ones. In order: one with the
    /// right contents; one of the same light's view before something moved, now unwanted; one that no other view has;
    /// a new one, while there are fewer than `most`. At most `most` may be wanted.
    std::vector<uint32_t> choose(uint32_t id, const std::vector<const MapContent*>& wanted, uint32_t most);

    struct Layer {
        MapContent content;
        std::vector<uint32_t> moved;  ///< since the same view was drawn before
    };
    /// The latest drawing of the same light's view, if the wanted one is missing.
    const Layer* before(const MapContent& wanted) const;

    /// Invalidates all layers.
    void forget() {
        layers_.assign(layers_.size(), {});
        ++changes_;
    }
    /// Nor are the layers.
    void clear() {
        layers_.clear();
        of_view_.clear();
        ++changes_;
    }

    size_t size() const { return layers_.size(); }
    const Layer& operator[](uint32_t layer) const { return layers_[layer]; }
    void set(uint32_t layer, Layer drawn) {
        layers_[layer] = std::move(drawn);
        ++changes_;
    }

    /// Another number after each change of contents, or of a view's choice.
    uint64_t changes() const { return changes_; }

  private:
    std::vector<Layer> layers_;
    uint64_t changes_ = 0;
    std::map<uint32_t, std::vector<uint32_t>> of_view_;
};
// [/map_layers]

}  // namespace lightwalk
