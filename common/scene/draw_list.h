// Selections of scene items, in drawing order.
#pragma once
#include "common/gpu/pass.h"
#include "common/scene/mesh.h"

namespace lightwalk {

class Scene;
struct DrawItem;

/// Consecutive items of equal mesh, part, winding and textures, for one draw call. Valid until load or animation.
class Batch : public Drawable {
  public:
    Batch(const Scene& scene, uint32_t first_item, uint32_t items) : first(first_item), count(items), scene_(&scene) {}
    uint32_t first, count;

    /// Representative item: mesh, part, textures and material properties common to the batch.
    const DrawItem& item() const;

    void draw(Raster& pass) const override;

    /// Binds resources as draw() does, for a custom draw with gl_InstanceIndex in [first, first + count).
    void bind(Raster& pass) const;

  private:
    const Scene* scene_;
};

/// Ordered subset of a scene's items. Valid until the scene is loaded; keeps its order when items move.
class DrawList : public Drawable {
  public:
    DrawList(const Scene& scene, std::vector<uint32_t> items) : scene_(&scene), items_(std::move(items)) {}

    /// Binds buffers and those textures that the pipeline uses, and draws; one draw call per run of a batch.
    void draw(Raster& pass) const override;

    /// Back-to-front order by distance of bounds centres from `eye` (metres, world space); stable.
    DrawList sorted_from(glm::vec3 eye) const;

    /// Conservative frustum culling: -w <= x, y <= w and 0 <= z <= w, for either depth direction and infinite far
    /// planes.
    DrawList inside(const glm::mat4& view_projection) const;

    template <class Predicate>
    DrawList where(Predicate predicate) const;

    /// For callers that choose pipelines or bind resources per batch.
    std::vector<Batch> batches() const;

    const std::vector<uint32_t>& items() const { return items_; }
    size_t size() const { return items_.size(); }

  private:
    const Scene* scene_;
    std::vector<uint32_t> items_;
};

/// Visibility test of DrawList::inside(). Empty boxes count as visible.
bool may_show(const Bounds& box, const glm::mat4& view_projection);

}  // namespace lightwalk
