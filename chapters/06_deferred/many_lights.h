// World of many lights: surfaces through a G-buffer, and screens that show the scene from elsewhere.
#pragma once
#include "03_attenuation/scattered_lights.h"
#include "06_deferred/deferred_scene.h"
#include "common/app/drawing.h"
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/app/world.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Objects with the role screen show the view along -z of the object named by `shows`, which needs no model. The
/// picture replaces the screen's colour and emissive textures. Per frame: record(); then passes that draw screens, with
/// the module in `.with`.
struct Screens : Module {
    Screens(Module& owner, std::string name);

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

/// Houses in rows along streets parallel to z: bodies, roofs, doors, windows, columns. Equal numbers
/// give equal towns on every machine.
std::vector<SceneObject> town_objects(int count);

/// Adds a town to the scene's objects; declared before the modules that prepare them.
struct Town : Module {
    Town(Module& owner, std::string name) : Module(owner, std::move(name)) {}
    Knob<int> objects{*this, "objects", 0, {0, 1000000}, "Number of objects in a town added to the scene"};

    void prepare(Gpu& gpu, Scene& scene) override;
    std::string load_key() const override { return objects.text(); }
};

// [many_lights]
struct ManyLights : World {
    explicit ManyLights(Module& owner) : World(owner) {
        objects.surfaces.all_lights = [this](const Frame& frame) { return all_lights(frame); };
        objects.surfaces.drawn = [this] { return screens.batches(scene()); };
        objects.shading.with = {screens};
    }
    Town town{*this, "town"};  // declared first: other modules prepare its objects
    DeferredScene objects{*this, "objects"};
    Screens screens{*this, "screens"};
    ScatteredLights scattered{*this};
    Knob<bool> moving{*this, "moving", false, "Animation of the point and spot lights"};

    bool animated() const override { return moving; }
    Drawings drawings() override { return {objects}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }

  protected:
    // Pictures of the scene's screens, from other cameras, shaded forward.
    void record(Frame& frame) override {
        screens.record(frame, scene(),
                       [&](const View& from, Canvas& into) { objects.lit.draw_lit(frame, from, into); });
    }

    virtual LightList all_lights(const Frame& frame) {
        return scattered.all(frame.seed, moving ? std::optional(frame.time_s) : std::nullopt);
    }
};
// [/many_lights]

}  // namespace lightwalk
