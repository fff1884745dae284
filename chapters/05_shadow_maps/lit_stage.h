// Stage world: a scene's objects under lights whose shadows come from maps or from rays.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/sphere_shadow.h"
#include "common/app/world.h"

namespace lightwalk {

// [stage]
struct LitStage : World {
    explicit LitStage(Module& owner) : World(owner) {
        objects.surfaces.all_lights = [this](const Frame&) { return lamps(); };
    }

    LitScene objects{*this, "objects"};
    Rays rays{*this, "rays"};
    SphereShadow sphere_shadow{*this, "sphere_shadow"};
    Choice visibility{
        *this,
        "visibility",
        {"maps", "rays"},
        "maps",
        "Shadows: from shadow maps (maps), or ray traced to points all over each light (rays), the reference"};
    Knob<float> lamp{*this, "lamp", 1.0f, {0.0f, 100.0f}, "Scale factor for all light sizes"};
    Choice show{*this,
                "show",
                {"picture", "visibility", "wrong", "map", "texels"},
                "picture",
                "View: picture, light visibility, errors against rays (wrong: acne red, peter-panning blue, leaks "
                "yellow, edges violet), the map in use, or the size of its texels"};

    Drawings drawings() override { return {objects}; }
    glm::vec4 background() const override { return {glm::vec3(World::background()), 0.0f}; }  // alpha 0: background
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }
    // [/stage]

    /// The scene's lights, with their sizes scaled.
    const LightList& lamps();
    /// Chooses the shading for `show` and `visibility`, and builds the hierarchy if rays are needed.
    void choose_shading(Frame& frame);

  protected:
    void record(Frame& frame) override { choose_shading(frame); }

  private:
    Fingerprint lamps_made_;
    LightList own_, lamps_;
    SurfacePipelines shown_{{.fragment = "05_shadow_maps/shown.frag"}};
    Pipeline shown_seen_ = compute({.shader = "05_shadow_maps/shown_seen.comp"});
};

}  // namespace lightwalk
