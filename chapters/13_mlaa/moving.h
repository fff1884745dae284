// Motion vectors of objects that move.
#pragma once
#include <map>

#include "common/app/drawing.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// A pass over motion vectors: the image, and what 13_mlaa/put_motion.glsl needs.
struct MotionPass {
    ImageView into, depth;
    struct FromTo {
        glm::mat4 now, before;
    } from_to;  ///< world to clip space, without the shifts within a pixel
};

/// A drawing that moves by itself, and is no item of a scene, implements it.
struct MovingSurface {
    virtual ~MovingSurface() = default;
    /// Since the frame before; false where that frame did not draw it.
    virtual bool has_moved() const = 0;
    /// Draws over the image.
    virtual void draw_motion(Frame& frame, const MotionPass& pass) const = 0;
};

/// By how many pixels the surface in a pixel has moved since the frame before, for items of a scene that were placed
/// elsewhere or deformed, and for moving surfaces; nothing for all others, which the camera's motion is enough for.
class Moving {
  public:
    /// Draws them over the depth of the frame; false where nothing moves. `before`: the view of the frame before.
    /// `drawings`: all of the picture's.
    bool record(Frame& frame, const Scene& scene, const View& now, const View& before, const ImageView& depth,
                const Drawings& drawings = {});

    /// Keeps where everything is now, for the frame that follows.
    void keep(Frame& frame, const Scene& scene);

    /// RGBA16F: pixels to where it was (x, y), its distance along that view in metres, and the share of its light
    /// that stays from frame to frame: 1, of water less, and 0 where there is no vector.
    const Image& image() const { return image_; }

  private:
    DrawList moved_items(const Scene& scene) const;
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
