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
    glm::vec4 background() const override { return {glm::vec3(World::background()), 0.0f}; }  // not counted as wrong
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }
    // [/stage]

  protected:
    void record(Frame& frame) override;

  private:
    const LightList& lamps();
    Fingerprint lamps_made_;
    LightList own_, lamps_;  ///< the scene's lights, and these with their sizes scaled
    SurfacePipelines shown_{{.fragment = "05_shadow_maps/shown.frag"}};
    Pipeline shown_seen_ = compute({.shader = "05_shadow_maps/shown_seen.comp"});
};

}  // namespace lightwalk
