// Drawings: modules that render into a canvas from a view.
#pragma once
#include <functional>
#include <span>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/view.h"

namespace lightwalk {

class Drawing;
class TransparencyMethod;

struct Drawings : std::vector<std::reference_wrapper<Drawing>> {
    Drawings() = default;
    /// Throws Failure, which names the statement `where`, for a drawing that is given twice.
    Drawings(std::initializer_list<std::reference_wrapper<Drawing>> all,
             SourceLocation where = SourceLocation::current());
};

/// Draw order. Each phase may depend on depth and light of earlier ones. Transparent surfaces follow the last phase.
enum class Phase {
    backdrop,  ///< overwrites the whole canvas
    opaque,
    sky,    ///< where depth is still cleared
    water,  ///< over everything it reflects and refracts
    air,    ///< participating media, ended by depth
    fog
};
const char* name_of(Phase phase);

/// Render targets shared by drawings. The first pass that draws into a target clears it.
class Canvas {
  public:
    /// `color`: RGBA16F, linear. `depth`: D32F, reversed, or none without depth tests. `background`: clear colour.
    Canvas(const ImageView& color, const ImageView& depth, const glm::vec4& background = {0.0f, 0.0f, 0.0f, 1.0f})
        : color_(color), depth_(depth), background_(background) {}

    /// Renders into multisampled images, resolved into the canvas after each pass.
    Canvas& multisampled(const ImageView& colors, const ImageView& depths);

    /// Method for blending transparent surfaces; null: back to front by object.
    Canvas& blended_by(TransparencyMethod* method);
    TransparencyMethod* transparency_method() const { return colors_ ? nullptr : transparency_method_; }

    /// Targets for a raster pass; cleared on first use.
    Attachment color_target();
    Attachment depth_target();
    Attachment depth_read_only() const;

    /// Single-sampled depth, for passes that read depth before shading.
    Attachment single_depth_target() { return depths_ ? clear(depth_, 0.0f) : depth_target(); }
    const ImageView& single_depth() const { return depth_; }

    /// Images to sample, or to write from compute; cleared if nothing was drawn yet.
    const ImageView& color(Frame& frame);
    const ImageView& depth(Frame& frame);

    const ImageView& color_overwritten();
    const ImageView& depth_overwritten();

    /// Announces the next drawing. Throws Failure if it has been drawn, or if a later phase has begun: its result would be
    /// overwritten.
    void enter(const Drawing& drawing);

    bool has_color() const { return color_begun_; }
    bool has_depth() const { return depth_begun_; }
    bool keeps_depth() const { return bool(depth_); }
    glm::uvec2 size() const { return color_.size(); }
    const glm::vec4& background() const { return background_; }

  private:
    ImageView color_, depth_, colors_, depths_;
    glm::vec4 background_;
    TransparencyMethod* transparency_method_ = nullptr;
    void begin_color();
    bool color_begun_ = false, depth_begun_ = false;
    std::vector<const Drawing*> entered_;
};

/// Transparent surfaces, drawn after all opaque ones, farthest first.
class TransparentSource {
  public:
    virtual ~TransparentSource() = default;

    struct Transparent {
        float distance_m;  ///< from the camera to its centre
        uint32_t item;     ///< number assigned by the source
        glm::vec3 middle;  ///< centre in metres, world space
    };
    virtual std::vector<Transparent> transparent(const View&) const = 0;

    /// Modules and resources of the transparent pass, and draws of surfaces in the given order. Fragment shaders end
    /// with put_surface() (common/put_surface.glsl), through which the method receives colour, alpha and tint.
    virtual std::vector<With> transparent_with() const { return {}; }
    virtual std::vector<Resource> transparent_reads() const { return {}; }
    virtual void draw_transparent(Raster&, std::span<const Transparent>) const = 0;

    /// Transparent triangle, for methods that sort triangles. An empty list: unsupported, or none.
    struct TransparentTriangle {
        float distance_m;
        uint32_t item;
        glm::uvec3 vertices;  ///< indices into the mesh of `item`
    };
    virtual std::vector<TransparentTriangle> transparent_triangles(const View&) const { return {}; }
    /// Draws `count` indices of `indices`, from `first` on, with the vertices of `item`.
    virtual void draw_transparent_triangles(Raster&, uint32_t /*item*/, const Buffer& /*indices*/, uint32_t /*first*/,
                                            uint32_t /*count*/) const {}
};

/// Module that renders. Shared state it may read: view, the scene's sun, exposure.
class Drawing : public Module {
  public:
    using Module::Module;

    virtual Phase draw_phase() const { return Phase::opaque; }

    /// Called once a frame, before any update(): sets the scene's sun if this drawing has one.
    virtual void update_sun() {}

    /// Drawing that provides sun and atmosphere; null: the scene's lights.
    virtual const Drawing* sun_source() const { return nullptr; }

    /// Called once a frame, before any update(), with all drawings of the frame. Shadow maps find their casters here.
    virtual void find_casters(const Drawings&) {}

    /// Modules whose knobs or animation affect the picture.
    virtual std::vector<const Module*> dependencies() const { return {this}; }

    /// Called once a frame, before the first draw: work shared by all views.
    virtual void update(Frame&) {}

    /// Renders the view into the canvas. Shaders have the uniform block `view`.
    virtual void draw(Frame&, const View&, Canvas&) = 0;

    /// Transparent surfaces; null: none at present.
    virtual const TransparentSource* transparent_source() const { return nullptr; }

    /// Calls update_sun(), update() or find_casters() unless already done in this frame.
    void update_sun_once(const Frame& frame);
    void update_once(Frame& frame);
    void find_casters_once(const Frame& frame, const Drawings& all);
    bool has_updated_sun(const Frame& frame) const { return sun_updated_ == frame.number(); }

  private:
    uint64_t sun_updated_ = 0, met_ = 0, updated_ = 0;
};

struct TransparentSurface {
    const TransparentSource* source;
    TransparentSource::Transparent what;
};

class TransparencyMethod {
  public:
    virtual ~TransparencyMethod() = default;
    virtual void record(Frame&, const View&, Canvas&, const std::vector<TransparentSurface>&) = 0;
};

std::vector<TransparentSurface> transparent_surfaces(const View& view, const Drawings& drawings);

/// Draws surfaces in order; consecutive ones of a drawing share a pass. `targets` are always cleared.
void draw_surfaces(Frame& frame, const std::string& pass, RasterTargets targets,
                   const std::vector<TransparentSurface>& surfaces);

/// Drawings in use, sorted by phase; stable within a phase.
Drawings in_order(const Drawings& drawings);

Drawings of_phases(std::initializer_list<Phase> phases, const Drawings& drawings);

/// Updates all suns, then state shared by views, once a frame. Throws Failure if a drawing lacks its light.
void update(Frame& frame, const Drawings& drawings);

/// Updates and renders all drawings by phase, then transparent surfaces. Messages begin with the statement `where`.
void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings,
          SourceLocation where = SourceLocation::current());

/// Renders everything but transparent surfaces; draw_transparent() renders only these.
void draw_opaque(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings,
                 SourceLocation where = SourceLocation::current());
void draw_transparent(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

}  // namespace lightwalk
