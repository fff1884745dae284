// Stage world: a scene's objects under lights whose shadows come from maps or from rays.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/ringed_planet.h"
#include "common/app/module.h"
#include "common/app/world.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// GLSL: planet_visibility() of 05_shadow_maps/planet_shadow.glsl. update() per frame; then passes with the module in
/// `.with`.
struct SphereShadow : Module {
    SphereShadow(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "hard", "power", "exact"},
                  "exact",
                  "Planet shadow: none, a hard outline, an edge softened by a power, or the hidden part of the sun's "
                  "disc (exact)"};
    Knob<float> width{*this, "width", 0.2f, {1e-3f, 1.0f}, "Width of the soft edge of method power, in sphere radii"};
    Knob<float> power{*this, "power", 0.5f, {0.05f, 8.0f}, "Exponent of the soft edge of method power"};
    Knob<float> sun_deg{
        *this, "sun_deg", 0.53f, {1e-3f, 60.0f}, "Angular diameter of the sun for method exact, in degrees", "degrees"};

    /// Finds the objects with the roles planet and ring: a sphere and a flat ring around its centre. Either may be
    /// missing.
    void update(const Scene& scene);

    /// Whether update() found a planet.
    explicit operator bool() const { return planet.radius > 0.0f; }

    RingedPlanet planet{};  ///< set by update() or by the owner
    /// Ring colours from the inner to the outer edge, opacity in alpha; any image without a ring.
    const Image* ring = nullptr;

    void bind(Pass& pass) const override;

    /// Pipelines of a planet and its ring.
    const SurfacePipelines ringed{{.fragment = "05_shadow_maps/ringed.frag"}};
    const SurfacePipelines ringed_transparent{{.fragment = "05_shadow_maps/ringed.frag",
                                               .depth_write = false,
                                               .blend = Blend::filtered,
                                               .macros = {{"TRANSPARENT", "1"}}}};
};

struct LitStage : World {
    explicit LitStage(Module& owner);

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
