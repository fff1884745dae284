// Mirror module: the mirror image of a scene in a level water surface.
#pragma once
#include "common/app/world.h"

namespace lightwalk {

// [mirror]
/// record() before the water is drawn; then image() holds the reflection of the level water at each pixel, counted
/// from the opposite edge. Water among the drawings is omitted: a mirror does not see itself.
struct Mirror : Module {
    Mirror(Module& owner, std::string name) : Module(owner, std::move(name), "mirror") {}

    Knob<float> scale{*this, "scale", 0.5f, {0.1f, 1.0f}, "Width of the mirror image, as a share of the picture's"};

    /// Opaque drawings are drawn with the water as their near plane, then sky, air and fog behind and before them.
    void record(Frame& frame, const View& view, float level_m, const Drawings& drawings);
    void record(Frame& frame, const View& view, float level_m, World& world) {
        record(frame, view, level_m, world.prepare_view(frame, view));
    }
    const Image& image() const { return color_; }
    const Image& depth() const {
        return depth_;
    }  ///< as the mirrored camera's own near and far planes give it
       // [/mirror]

  private:
    DerivedViews views_;
    Image color_, oblique_, depth_;
    Pipeline plain_depth_ = graphics({.vertex = "06_deferred/whole.vert",
                                      .fragment = "15_terrain_water/plain_depth.frag",
                                      .cull = VK_CULL_MODE_NONE,
                                      .depth_compare = Compare::always});
};

/// The camera below the water that sees the mirrored view, flipped left to right.
Camera mirrored_camera(const Camera& camera, float level_m);

}  // namespace lightwalk
