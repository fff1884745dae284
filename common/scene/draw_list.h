// What of a scene is drawn, and in what order.
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

    /// What all of them have in common: mesh, part, textures, which of the material's numbers stand for 'none'.
    const DrawItem& item() const;

    void draw(Raster& pass) const override;

    /// Binds what draw() does, for a batch that is drawn otherwise: gl_InstanceIndex has to run from `first` to below
    /// first + count.
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

    /// Back to front: the middle of the bounds that is farthest from `eye` (metres, world space) comes first; what is
    /// equally far stays in its order.
    DrawList sorted_from(glm::vec3 eye) const;

    /// Without items whose bounds lie wholly outside of what the matrix shows: -w <= x, y <= w and 0 <= z <= w, in
    /// whichever direction depth goes and with or without a far plane. An item that shows is never left out; one near
    /// an edge of the frustum may stay though it does not show.
    DrawList inside(const glm::mat4& view_projection) const;

    /// Those for which predicate(const DrawItem&) holds.
    template <class Predicate>
    DrawList where(Predicate predicate) const;

    /// For whoever chooses a pipeline or binds something by batch.
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
