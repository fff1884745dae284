// Worlds: a chapter's composition, as a member that others can hold.
#pragma once
#include "common/app/drawing.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [world]
/// A scene's drawings and how they are joined. A chapter draws it to the screen; a film's scene along a path; a mirror, a
/// light probe or a screen from elsewhere. Its members have the owner's paths: an option is the same in each of them.
///
///     struct Shore : World {
///         using World::World;
///         Land land{*this, "land"};
///         Water water{*this, "water"};
///         Drawings drawings() override { return {land, water}; }
///     };
class World : public Module {
  public:
    explicit World(Module& owner) : Module(owner, "") {}

    /// All of them. Those in use are drawn, by phase.
    virtual Drawings drawings() = 0;

    /// The scene's light from a view, into a canvas of any size. The scene was placed by animate() before.
    void draw_light(Frame& frame, const View& view, Canvas& canvas);
    /// The drawings, prepared for a view, for callers that draw them in another way.
    Drawings ready(Frame& frame, const View& view);

    /// Colour where nothing is drawn.
    virtual glm::vec4 background() const { return glm::vec4(scene_->file.background, 1.0f); }

    /// Where a picture is taken from.
    struct Eye {
        Camera camera;
        std::optional<glm::dvec3> exact{};  ///< View::exact_eye
    };
    /// The camera given, unless the world has one of its own.
    virtual Eye eye(const Frame&, const Camera& given) { return {given}; }

    /// Default display settings for its light: knobs by path, such as post.tone.
    virtual std::vector<std::pair<std::string, std::string>> look() const { return {}; }

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }

  protected:
    /// Once a frame, before its first view: shared work beyond the drawings' own update().
    virtual void record(Frame&) {}

    /// Prerequisites of a view, such as a mirror image.
    virtual void record_view(Frame&, const View&) {}

    /// draw(), unless something comes between the drawings.
    virtual void draw_view(Frame& frame, const View& view, Canvas& canvas) { draw(frame, view, canvas, drawings()); }

    Scene& scene() { return *scene_; }
    // [/world]

  private:
    Scene* scene_ = nullptr;
    uint64_t begun_ = 0;  ///< Frame::number()
};

/// Applies world.look() as default values to the knobs of `shown_by`, which has bloom, tones and the like.
void set_look(const World& world, const Module& shown_by);

}  // namespace lightwalk
