// Screens module: pictures from other cameras on objects of the scene.
#pragma once
#include "common/app/drawing.h"
#include "common/app/target.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [screens]
/// Objects with the role screen show the view along -z of the object named by `shows`, which needs no model. The
/// picture replaces the screen's colour and emissive textures. Per frame: record(); then passes that draw screens, with
/// the module in `.with`.
struct Screens : Module {
    Screens(Module& owner, std::string name) : Module(owner, std::move(name), "screens") {}

    Knob<int> width{
        *this, "width", 480, {16, 4096}, "Width of a screen's picture, in pixels; its height is 9/16 of it", "pixels"};
    Knob<float> fov_deg{
        *this,    "fov_deg", 50.0f, {1.0f, 170.0f}, "Vertical field of view of the screens' cameras, in degrees",
        "degrees"};

    /// Draws a screen's picture.
    using Draw = std::function<void(const View& view, Canvas& canvas)>;

    /// Finds the scene's screens. Throws InputError for one without a camera.
    void prepare(Gpu& gpu, Scene& scene) override;
    std::string load_key() const override { return width.text(); }
    bool animated() const override { return !screens_.empty(); }

    /// Draws each screen's view. Screens within it show the previous frame, or black, since a picture cannot be read
    /// while it is drawn.
    void record(Frame& frame, Scene& scene, const Draw& draw);
    // [/screens]

    /// Opaque batches of the scene, with each screen in a batch of its own.
    std::vector<Batch> batches(const Scene& scene) const;

    std::vector<Resource> reads() const override;
    size_t count() const { return screens_.size(); }

  private:
    struct Screen {
        Screen(Module& owner, const std::string& name, glm::uvec2 size);
        History picture;
        Target depth;
        size_t camera = 0, object = 0;  ///< indices into SceneFile::objects
        const Image* shown = nullptr;
    };
    void show(Scene& scene, bool before);
    bool is_screen(const DrawItem& item) const;
    std::vector<std::unique_ptr<Screen>> screens_;
    DerivedViews views_;
    Image black_, light_;
    Pipeline encode_ = compute({.shader = "common/encode_srgb.comp"});
};

}  // namespace lightwalk
