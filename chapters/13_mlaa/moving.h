// Motion vectors of objects that move.
#pragma once
#include <map>

#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

// [moving]
/// By how many pixels the surface in a pixel has moved since the frame before, for items of a scene that were placed
/// elsewhere or deformed; nothing for all others, which the camera's motion is enough for.
class Moving {
  public:
    /// Draws them over the depth of the frame; false where nothing moves. `before`: the view of the frame before.
    bool record(Frame& frame, const Scene& scene, const View& now, const View& before, const ImageView& depth);

    /// Keeps where everything is now, for the frame that follows.
    void keep(Frame& frame, const Scene& scene);

    /// RGBA16F: pixels to where it was (x, y), its distance along that view in metres, and 1 where there is any.
    const Image& image() const { return image_; }
    // [/moving]

  private:
    const Buffer& vertices_before(const DrawItem& item) const;
    Image image_;
    Buffer instances_;                                               ///< of the frame before
    std::map<std::pair<const GpuModel*, size_t>, Buffer> deformed_;  ///< vertices of the frame before, by mesh
    std::vector<glm::mat4> transforms_;                              ///< of the items, in the frame before
    uint64_t placed_ = 0;                                            ///< Scene::placed of the frame before
    Pipeline draw_ = graphics({.vertex = "13_mlaa/moving.vert",
                               .fragment = "13_mlaa/moving.frag",
                               .depth_test = false,
                               .depth_write = false});
};

/// The view without its shift within a pixel.
glm::mat4 without_shift(const View& view);

}  // namespace lightwalk
