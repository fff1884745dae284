// Shadows that need no map, as a module: of a sphere on its ring, and of the ring on the sphere.
#pragma once
#include "05_shadow_maps/ringed_planet.h"
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [sphere_shadow]
/// Gives shaders planet_visibility() of 05_shadow_maps/planet_shadow.glsl. update() in each frame; then passes may
/// state it in `.with`.
struct SphereShadow : Module {
    SphereShadow(Module& owner, std::string name) : Module(owner, std::move(name), "sphere_shadow") {}

    Choice method{
        *this,
        "method",
        {"none", "hard", "power", "exact"},
        "exact",
        "the sphere's shadow: its outline, softened by a power, or the share of the sun's disc that it hides"};
    Knob<float> width{*this, "width", 0.2f, {1e-3f, 1.0f}, "of the edge that power softens, in radii of the sphere"};
    Knob<float> power{*this, "power", 0.5f, {0.05f, 8.0f}, "of how deep a point is in that edge"};
    Knob<float> sun_deg{*this, "sun_deg", 0.53f, {1e-3f, 60.0f}, "how wide the sun looks, for exact", "degrees"};

    /// Takes the scene's planet and ring, the objects with these roles: a ball and a flat ring around its middle. Either
    /// may be missing.
    void update(const Scene& scene);

    /// Whether update() found a planet.
    explicit operator bool() const { return planet.radius > 0.0f; }

    RingedPlanet planet{};  ///< update()'s, or set otherwise
    /// Its colours from the inner to the outer edge, and in alpha what they hide; with no ring any image.
    const Image* ring = nullptr;

    void bind(Pass& pass) const override;
};
// [/sphere_shadow]

}  // namespace lightwalk
