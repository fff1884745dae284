// Sphere shadow module: shadows without maps, of a sphere on its ring and of the ring on the sphere.
#pragma once
#include "04_surface_maps/surface_pipelines.h"
#include "05_shadow_maps/ringed_planet.h"
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [sphere_shadow]
/// GLSL: planet_visibility() of 05_shadow_maps/planet_shadow.glsl. update() per frame; then passes with the module in
/// `.with`.
struct SphereShadow : Module {
    SphereShadow(Module& owner, std::string name) : Module(owner, std::move(name), "sphere_shadow") {}

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
                                               .blend = Blend::alpha,
                                               .macros = {{"TRANSPARENT", "1"}}}};
};
// [/sphere_shadow]

}  // namespace lightwalk
