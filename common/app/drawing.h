// Drawings: what draws a picture, into given targets, from a given view.
#pragma once
#include <functional>
#include <span>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/view.h"

namespace lightwalk {

class TransparencyMethod;

// [phase]
/// When a drawing is drawn, wherever it stands in a list: each phase needs the depth or the light that the earlier ones
/// leave. Transparent surfaces follow all of them.
enum class Phase {
    backdrop,  ///< overwrites the whole canvas
    opaque,
    sky,    ///< where nothing has depth
    water,  ///< over all that it reflects and refracts
    air,    ///< participating media that the depth ends
    fog
};
const char* name_of(Phase phase);
// [/phase]

// [canvas]
/// The targets that drawings share, all of one size. The first pass that draws into one clears it, so that no drawing
/// clears what another has drawn.
class Canvas {
  public:
    /// `color`: RGBA16F, linear; `depth`: D32F, reversed, or none where one drawing is the whole picture and finds what
    /// is nearest without it. `background`: what is seen where nothing is drawn.
    Canvas(const ImageView& color, const ImageView& depth, const glm::vec4& background = {0.0f, 0.0f, 0.0f, 1.0f})
        : color_(color), depth_(depth), background_(background) {}

    /// Draws into images with several samples a pixel instead, whose mean goes into the canvas after each pass.
    Canvas& multisampled(const ImageView& colors, const ImageView& depths);

    /// By what transparent surfaces are mixed with what lies behind them; null: drawn back to front, by object.
    Canvas& mixed_by(TransparencyMethod* method);
    TransparencyMethod* mixing() const { return colors_ ? nullptr : mixing_; }  ///< one sample a pixel only

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

    /// A drawing of this phase comes next. Throws Failure where one of a later phase was drawn: it would be overwritten.
    void enter(Phase phase, const std::string& drawing);

    bool has_color() const { return color_begun_; }
    bool has_depth() const { return depth_begun_; }
    bool keeps_depth() const { return bool(depth_); }
    glm::uvec2 size() const { return color_.size(); }
    const glm::vec4& background() const { return background_; }

  private:
    ImageView color_, depth_, colors_, depths_;
    glm::vec4 background_;
    TransparencyMethod* mixing_ = nullptr;
    void begin_color();
    bool color_begun_ = false, depth_begun_ = false;
    Phase phase_ = Phase::backdrop;  ///< reached so far
    std::string last_;               ///< the drawing that reached it
};
// [/canvas]

// [drawing]
/// A module that draws. The frame-wide state it may know is the view, the scene's sun and the exposure.
class Drawing : public Module {
  public:
    using Module::Module;

    virtual Phase drawn_in() const { return Phase::opaque; }

    /// Once a frame, before any drawing is updated: what has a sun gives it to the scene.
    virtual void shine() {}

    /// The drawing whose sun and air light this one; null: the scene's lights.
    virtual const Drawing* lit_by() const { return nullptr; }

    /// The modules whose knobs, and whose motion, change what it draws.
    virtual std::vector<const Module*> made_of() const { return {this}; }

    /// Once a frame, before it is drawn for the first time: what all views share.
    virtual void update(Frame&) {}

    /// Draws into the canvas what the view sees. Shaders have the block `view` already.
    virtual void draw(Frame&, const View&, Canvas&) = 0;

    /// Transparent surfaces. They are drawn after all opaque ones, the farthest first.
    struct Transparent {
        float distance_m;  ///< of its middle from the eye
        uint32_t item;     ///< the drawing's own number
        glm::vec3 middle;  ///< metres, world space
    };
    virtual std::vector<Transparent> transparent(const View&) const { return {}; }

    /// What their pass is given, and the draw of some of them, in this order. Their fragment shaders end with
    /// put_surface() of common/put_surface.glsl: what that does with colour and alpha is the method's.
    virtual std::vector<With> transparent_with() const { return {}; }
    virtual std::vector<Resource> transparent_reads() const { return {}; }
    virtual void draw_transparent(Raster&, std::span<const Transparent>) const {}

    /// Their triangles one by one, for methods that order those. None: the drawing cannot tell, or has none.
    struct TransparentTriangle {
        float distance_m;     ///< of its middle from the eye
        uint32_t item;        ///< whose it is
        glm::uvec3 vertices;  ///< of the item's mesh
    };
    virtual std::vector<TransparentTriangle> transparent_triangles(const View&) const { return {}; }
    /// Draws `count` indices of a buffer from `first` on with an item's vertices.
    virtual void draw_transparent_triangles(Raster&, uint32_t /*item*/, const Buffer& /*indices*/, uint32_t /*first*/,
                                            uint32_t /*count*/) const {}
    // [/drawing]

    /// shine() or update(), unless this frame has had it.
    void shine_once(const Frame& frame);
    void update_once(Frame& frame);
    bool has_shone(const Frame& frame) const { return shone_ == frame.number(); }

  private:
    uint64_t shone_ = 0, updated_ = 0;  ///< Frame::number
};

using Drawings = std::vector<std::reference_wrapper<Drawing>>;

// [transparency]
/// One transparent surface, and whose it is.
struct SeenThrough {
    const Drawing* drawing;
    Drawing::Transparent what;
};

/// Mixes transparent surfaces with what lies behind them, after all that is opaque was drawn. A canvas names it.
class TransparencyMethod {
  public:
    virtual ~TransparencyMethod() = default;
    virtual void record(Frame&, const View&, Canvas&, const std::vector<SeenThrough>&) = 0;
};

/// All transparent surfaces of the drawings, in their order.
std::vector<SeenThrough> transparent_surfaces(const View& view, const Drawings& drawings);

/// Draws them in this order into the targets, in one pass for neighbours that are of one drawing. `targets`: what all
/// passes have in common; what it clears is cleared once, also where there is nothing to draw.
void draw_surfaces(Frame& frame, const std::string& pass, RasterTargets targets,
                   const std::vector<SeenThrough>& surfaces);
// [/transparency]

/// The drawings that are in use, by phase; within a phase in the order given.
Drawings in_order(const Drawings& drawings);

/// Those of the phases given.
Drawings of_phases(std::initializer_list<Phase> phases, const Drawings& drawings);

/// All suns, then what all views share, unless this frame has had it. Throws Failure for a drawing without its light.
void update(Frame& frame, const Drawings& drawings);

/// Updates the drawings, draws them by phase, and then their transparent surfaces.
void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

/// The two halves of draw(), for what comes between them: everything but the transparent surfaces, and these alone.
void draw_opaque(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);
void draw_transparent(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

}  // namespace lightwalk
