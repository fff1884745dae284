// Height-fog module, for any picture in linear light.
#pragma once
#include "common/app/drawing.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// A drawing that comes after all solid objects, under the scene's sun; or in a shader of a pass that states it in `.with`,
/// with 10_atmosphere/height_fog_inputs.glsl:
///
///     vec3 through_fog(vec3 radiance, vec3 eye, vec3 direction, float distance, vec3 to_sun)
///
/// the light of a point as it arrives, or its parts fog_transmittance() and fog_color().
struct HeightFog : Drawing {
    HeightFog(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "uniform", "height"},
                  "height",
                  "Fog: none, of uniform density (falloff 0), or thinner with height"};
    Knob<float> density{*this, "density", 2e-4f, {0.0f, 10.0f}, "Extinction of the fog at its base", "1/m"};
    Knob<float> falloff{
        *this, "falloff", 0.01f, {0.0f, 10.0f}, "Reciprocal of the height over which the density falls to 37%", "1/m"};
    Knob<float> base_m{*this, "base_m", 0.0f, {-1e5f, 1e5f}, "Height at which the fog has its density", "m"};
    Knob<float> start_m{*this, "start_m", 0.0f, {0.0f, 1e6f}, "Distance from the camera at which fog begins", "m"};
    Knob<glm::vec3> color{*this,
                          "color",
                          {0.5f, 0.6f, 0.7f},
                          {glm::vec3(0.0f), glm::vec3(1e4f)},
                          "Radiance of infinitely deep fog, linear"};
    Knob<glm::vec3> sun_color{*this,
                              "sun_color",
                              {1.0f, 0.85f, 0.6f},
                              {glm::vec3(0.0f), glm::vec3(1e4f)},
                              "Radiance of infinitely deep fog in the direction of the sun, linear"};
    Knob<float> sun_power{
        *this, "sun_power", 8.0f, {0.1f, 1e3f}, "Exponent of the glow towards the sun; larger values are narrower"};

    float sky_m = 1e5f;  ///< how far fog reaches where nothing is drawn, unless it meets base_m before

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }

    /// Adds fog to the canvas, by the canvas's depth. One pass, none with method none. Alpha stays.
    Phase draw_phase() const override { return Phase::fog; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    const Scene* scene_ = nullptr;
    Pipeline fog_ = compute({.shader = "10_atmosphere/fog.comp"});
};

}  // namespace lightwalk
