// Worlds: scene compositions shared by chapters.
#pragma once
#include "common/app/drawing.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Drawings of a scene and their composition. Members have the owner's paths: options are equal in all chapters.
class World : public Module {
  public:
    explicit World(Module& owner) : Module(owner, "") {}

    virtual Drawings drawings() = 0;

    /// Renders linear light of a view into a canvas of any size. Requires Scene::animate() for the frame.
    void draw_light(Frame& frame, const View& view, Canvas& canvas);
    /// Prepares the drawings for a view, for callers that render them differently.
    Drawings prepare_view(Frame& frame, const View& view);

    virtual glm::vec4 background() const { return glm::vec4(scene_->file.background, 1.0f); }

    struct Eye {
        Camera camera;
        std::optional<glm::dvec3> exact{};  ///< View::exact_eye
    };
    /// Camera of the world, by default the given one.
    virtual Eye eye(const Frame&, const Camera& given) { return {given}; }

    /// Default display settings: values by knob path, such as post.tone.
    virtual std::vector<std::pair<std::string, std::string>> look() const { return {}; }

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }

  protected:
    /// Called once a frame before its first view: shared work beyond update() of the drawings.
    virtual void record(Frame&) {}

    /// Prerequisites of a view, such as a mirror image.
    virtual void record_view(Frame&, const View&) {}

    /// Renders the drawings; override to insert passes between them.
    virtual void draw_view(Frame& frame, const View& view, Canvas& canvas) { draw(frame, view, canvas, drawings()); }

    Scene& scene() { return *scene_; }

  private:
    Scene* scene_ = nullptr;
    uint64_t begun_ = 0;
};

/// Applies world.look() as default values to the knobs of `shown_by`, which displays the world.
void set_look(const World& world, const Module& shown_by);

}  // namespace lightwalk
