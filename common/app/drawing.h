// Drawings: what draws a picture, into given targets, from a given view.
#pragma once
#include <functional>
#include <span>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/view.h"

namespace lightwalk {

// [canvas]
/// The targets that drawings share, all of one size. The first pass that draws into one clears it, so that no drawing
/// clears what another has drawn.
class Canvas {
  public:
    /// `color`: RGBA16F, linear; `depth`: D32F, reversed. `background`: what is seen where nothing is drawn.
    Canvas(const ImageView& color, const ImageView& depth, const glm::vec4& background = {0.0f, 0.0f, 0.0f, 1.0f})
        : color_(color), depth_(depth), background_(background) {}

    /// Draws into images with several samples a pixel instead, whose mean goes into the canvas after each pass.
    Canvas& multisampled(const ImageView& colors, const ImageView& depths);

    /// To draw into, in a raster pass; the first time cleared.
    Attachment color_target();
    Attachment depth_target();
    Attachment depth_read_only() const;

    /// Depth with one sample per pixel, for passes that read it before the surfaces are shaded.
    Attachment single_depth_target() { return depths_ ? clear(depth_, 0.0f) : depth_target(); }
    const ImageView& single_depth() const { return depth_; }

    /// To read, or to write from compute; cleared where nothing was drawn yet.
    const ImageView& color(Frame& frame);
    const ImageView& depth(Frame& frame);

    /// To overwrite whole from compute, whatever is there.
    const ImageView& color_overwritten();
    /// For a pass that writes depth itself.
    const ImageView& depth_overwritten();

    bool has_color() const { return color_begun_; }
    bool has_depth() const { return depth_begun_; }
    glm::uvec2 size() const { return color_.size(); }
    const glm::vec4& background() const { return background_; }

  private:
    ImageView color_, depth_, colors_, depths_;
    glm::vec4 background_;
    bool color_begun_ = false, depth_begun_ = false;
};
// [/canvas]

// [drawing]
/// A module that draws. The frame-wide state it may know is the view, the scene's sun and the exposure.
class Drawing : public Module {
  public:
    using Module::Module;

    /// Once a frame, before it is drawn for the first time: what all views share.
    virtual void update(Frame&) {}

    /// Draws into the canvas what the view sees. Shaders have the block `view` already.
    virtual void draw(Frame&, const View&, Canvas&) = 0;

    /// Transparent surfaces. They are drawn after all opaque ones, the farthest first.
    struct Transparent {
        float distance_m;  ///< from the eye
        uint32_t item;     ///< the drawing's own number
    };
    virtual std::vector<Transparent> transparent(const View&) const { return {}; }

    /// What their pass is given, and the draw of some of them, in this order. `variant`: macros of the method by which
    /// they are mixed.
    virtual std::vector<With> transparent_with() const { return {}; }
    virtual std::vector<Resource> transparent_reads() const { return {}; }
    virtual void draw_transparent(Raster&, std::span<const Transparent>, const Macros& /*variant*/) const {}
    // [/drawing]

    /// update(), unless this frame has had it.
    void update_once(Frame& frame);

  private:
    uint64_t updated_ = 0;  ///< Frame::number
};

using Drawings = std::vector<std::reference_wrapper<Drawing>>;

/// Updates the drawings, unless this frame did so before, draws them in this order, and then their transparent surfaces.
void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

}  // namespace lightwalk
