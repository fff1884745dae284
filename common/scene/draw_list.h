// A selection of a scene's items, in drawing order.
#pragma once
#include "common/gpu/pass.h"
#include "common/scene/mesh.h"

namespace lightwalk {

class Scene;
struct DrawItem;

/// Neighbours in Scene::items with one mesh, part, winding and set of textures: instances of one draw call. Good until
/// the scene is loaded or animated.
class Batch : public Drawable {
  public:
    Batch(const Scene& scene, uint32_t first_item, uint32_t items) : first(first_item), count(items), scene_(&scene) {}
    uint32_t first, count;  ///< places in Scene::items

    /// Their common state: mesh, part, textures, and absent material properties.
    const DrawItem& item() const;

    void draw(Raster& pass) const override;

    /// Binds a batch as draw() does, for a custom draw: gl_InstanceIndex must run from `first` to below first +
    /// count.
    void bind(Raster& pass) const;

  private:
    const Scene* scene_;
};

/// Some of a scene's items. Good until the scene is loaded; its order is that of the moment it was made.
class DrawList : public Drawable {
  public:
    /// `items` are places in Scene::items, in the order in which they are to be drawn.
    DrawList(const Scene& scene, std::vector<uint32_t> items) : scene_(&scene), items_(std::move(items)) {}

    /// Binds `vertices` and the model's attributes, `instances`, `materials` and the textures that the pipeline's
    /// shaders name, and draws; neighbours of one batch are one call.
    void draw(Raster& pass) const override;

    /// Back to front: items with the farthest centre of bounds from `eye` (metres, world space) first; equal ones
    /// keep their order.
    DrawList sorted_from(glm::vec3 eye) const;

    /// Without items fully outside the matrix's clip volume: -w <= x, y <= w and 0 <= z <= w, for either depth
    /// direction, with or without a far plane. Conservative: a visible item is never dropped; one near an edge may
    /// stay.
    DrawList inside(const glm::mat4& view_projection) const;

    /// Those for which predicate(const DrawItem&) holds.
    template <class Predicate>
    DrawList where(Predicate predicate) const;

    /// For callers that choose a pipeline or bind resources by batch.
    std::vector<Batch> batches() const;

    const std::vector<uint32_t>& items() const { return items_; }
    size_t size() const { return items_.size(); }

  private:
    const Scene* scene_;
    std::vector<uint32_t> items_;
};

/// Whether DrawList::inside keeps this box. An empty box is kept: nothing is known of it.
bool may_show(const Bounds& box, const glm::mat4& view_projection);

}  // namespace lightwalk
