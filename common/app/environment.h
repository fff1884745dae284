// A scene's environment as light: a cube of radiance for reflections and one of irradiance for diffuse surfaces.
// Chapter 14 adds roughness.
#pragma once
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// The uniform block of common/environment.glsl.
struct EnvironmentScale {
    float cosine, sine;  ///< of the turn about +y, counter-clockwise seen from above
    float intensity;
};

/// Rotation and scale of the environment, in addition to the scene file's.
EnvironmentScale environment_scale(const Scene& scene, float intensity, float turn_deg);

/// Gives shaders environment_radiance() and environment_irradiance() of common/environment.glsl. In each frame
/// record(), before the first pass that states it in `.with`:
///
///     environment.record(frame, scene);
///     frame.raster("shade", {.color = {frame.hdr}, .depth = frame.depth, .with = {environment}}, ...);
///
/// A scene without a picture has its `ambient` as radiance from everywhere.
struct EnvironmentLight : Module {
    EnvironmentLight(Module& owner, std::string name);

    Knob<float> intensity{*this,
                          "intensity",
                          1.0f,
                          {0.0f, 1e4f},
                          "Scale factor for the radiance of the environment, in addition to the scene's own"};
    Knob<float> turn_deg{*this,
                         "turn_deg",
                         0.0f,
                         {-360.0f, 360.0f},
                         "Rotation of the environment about +y, in addition to the scene's own",
                         "°"};

    /// Makes both cubes, where the scene has another picture than they were made of; else it records nothing.
    void record(Frame& frame, const Scene& scene);

    std::vector<Resource> reads() const override { return {radiance, irradiance}; }
    void bind(Pass& pass) const override;

    /// Linear RGBA16F; the module's GLSL applies turn and intensity when they are read.
    Target radiance{*this,
                    {.name = "radiance", .size = {256, 256}, .mips = 0, .layers = 6, .cube = true, .kept = true}};
    Target irradiance{*this, {.name = "irradiance", .size = {24, 24}, .layers = 6, .cube = true, .kept = true}};

  private:
    const Image& picture_of(Frame& frame, const Scene& scene);
    Pipeline draw_ = compute({.shader = "common/environment_radiance.comp"});
    Pipeline sum_ = compute({.shader = "common/environment_irradiance.comp"});
    Image even_;  ///< where there is no picture
    Fingerprint even_made_;
    Fingerprint made_;
    std::shared_ptr<Image> made_from_;
    const Scene* scene_ = nullptr;  ///< of the last record()
};

}  // namespace lightwalk
