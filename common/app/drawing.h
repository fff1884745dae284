// Drawings: they draw a picture into given targets from a given view.
#pragma once
#include <functional>
#include <span>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/view.h"

namespace lightwalk {

class Drawing;
class TransparencyMethod;

using Drawings = std::vector<std::reference_wrapper<Drawing>>;

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
/// Targets of one size that drawings share. The first pass that draws into one clears it, so no drawing clears
/// another's result.
/// Large (20 functions, 10 members): targets, and what has happened to them.
class Canvas {
  public:
    /// `color`: RGBA16F, linear. `depth`: D32F, reversed, or none if a single drawing needs no depth test.
    /// `background`: colour where nothing is drawn.
    Canvas(const ImageView& color, const ImageView& depth, const glm::vec4& background = {0.0f, 0.0f, 0.0f, 1.0f})
        : color_(color), depth_(depth), background_(background) {}

    /// Draws into multisampled images instead; their mean is resolved into the canvas after each pass.
    Canvas& multisampled(const ImageView& colors, const ImageView& depths);

    /// Method that blends transparent surfaces with their background; null: back to front, by object.
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

    /// The target, for a compute pass that overwrites every pixel.
    const ImageView& color_overwritten();
    /// For a pass that writes depth itself.
    const ImageView& depth_overwritten();

    /// A drawing of this phase comes next. Throws Failure if one of a later phase was drawn: it would be overwritten.
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

    /// Once a frame, before any update: a drawing with a sun gives it to the scene.
    virtual void shine() {}

    /// The drawing that provides the sun and air; null: the scene's lights.
    virtual const Drawing* lit_by() const { return nullptr; }

    /// Once a frame, before any update: all drawings of the frame's first list, itself included. Owners of shadow maps
    /// look for casters there.
    virtual void meet(const Drawings&) {}

    /// The modules with knobs or motion that change the picture.
    virtual std::vector<const Module*> made_of() const { return {this}; }

    /// Once a frame, before the first draw: work shared by all views.
    virtual void update(Frame&) {}

    /// Draws into the canvas as seen from the view. Shaders already have the block `view`.
    virtual void draw(Frame&, const View&, Canvas&) = 0;

    /// Transparent surfaces. They are drawn after all opaque ones, the farthest first.
    struct Transparent {
        float distance_m;  ///< of its middle from the eye
        uint32_t item;     ///< the drawing's own number
        glm::vec3 middle;  ///< metres, world space
    };
    virtual std::vector<Transparent> transparent(const View&) const { return {}; }
    /// The drawing that has its transparent surfaces; null: there are none now.
    virtual const Drawing* transparent_part() const { return this; }

    /// Bindings of their pass, and the draw of some of them in this order. Their fragment shaders end with
    /// put_surface() of common/put_surface.glsl, by which the method handles colour and alpha.
    virtual std::vector<With> transparent_with() const { return {}; }
    virtual std::vector<Resource> transparent_reads() const { return {}; }
    virtual void draw_transparent(Raster&, std::span<const Transparent>) const {}

    /// Their triangles one by one, for methods that order those. None: the drawing cannot tell, or has none.
    struct TransparentTriangle {
        float distance_m;     ///< of its middle from the eye
        uint32_t item;        ///< index of the item it belongs to
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
    void meet_once(const Frame& frame, const Drawings& all);
    bool has_shone(const Frame& frame) const { return shone_ == frame.number(); }

  private:
    uint64_t shone_ = 0, met_ = 0, updated_ = 0;  ///< Frame::number
};

// [transparency]
/// One transparent surface and its drawing.
struct SeenThrough {
    const Drawing* drawing;
    Drawing::Transparent what;
};

/// Blends transparent surfaces with their background after all opaque drawing. A canvas names it.
class TransparencyMethod {
  public:
    virtual ~TransparencyMethod() = default;
    virtual void record(Frame&, const View&, Canvas&, const std::vector<SeenThrough>&) = 0;
};

/// All transparent surfaces of the drawings, in their order.
std::vector<SeenThrough> transparent_surfaces(const View& view, const Drawings& drawings);

/// Draws them in this order into the targets; neighbours of one drawing share a pass. `targets`: common to all
/// passes; cleared once, even if there is nothing to draw.
void draw_surfaces(Frame& frame, const std::string& pass, RasterTargets targets,
                   const std::vector<SeenThrough>& surfaces);
// [/transparency]

/// The drawings that are in use, by phase; within a phase in the order given.
Drawings in_order(const Drawings& drawings);

/// The drawings in the given phases.
Drawings of_phases(std::initializer_list<Phase> phases, const Drawings& drawings);

/// Updates all suns, then the state shared by all views, once per frame. Throws Failure if a drawing lacks its light.
void update(Frame& frame, const Drawings& drawings);

/// Updates the drawings, draws them by phase, and then their transparent surfaces.
void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

/// The two halves of draw(): everything but the transparent surfaces, and these alone.
void draw_opaque(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);
void draw_transparent(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

}  // namespace lightwalk
