// Workbench world: objects under many lights, in surroundings or under a sky, with terrain and water.
#pragma once
#include "03_attenuation/scattered_lights.h"
#include "06_deferred/deferred_scene.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "14_environment/backdrop.h"
#include "14_environment/paint.h"
#include "14_environment/probe.h"
#include "15_terrain_water/land.h"
#include "15_terrain_water/water.h"
#include "common/app/world.h"

namespace lightwalk {

// [workbench]
struct Workbench : World {
    explicit Workbench(Module& owner);

    Choice air{*this, "air", {"none", "sky"}, "none", "Surroundings: those of the scene, or a sky with its sun (sky)"};
    Knob<int> scattered{*this, "lights", 0, {0, 1000000}, "Number of random lights added to those of the scene"};

    ImageLight light{*this, "environment"};
    SceneProbe probe{*this, "probe"};  ///< of the sky, or of the room where that is asked
    Backdrop backdrop{*this, "backdrop", light};
    DeferredScene objects{
        *this, "objects",
        Shading{.opaque = &surface_, .seen = &seen_, .transparent = &glass_, .stored = &write_, .rest = &rest_}};
    Substances substances{*this, "substance"};
    CarPaint paint{*this, "paint"};
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Ground ground{*this, "ground"};  ///< of the scene's height map, under the sky
    Land land{*this, "land", ground, atmosphere};
    SunShadow sun_shadow{*this, "sun_shadow", atmosphere};  ///< of objects on the ground
    Water water{*this, "water", light};
    HeightFog fog{*this, "fog"};

    Drawings drawings() override { return {backdrop, land, objects, sky, water, atmosphere, fog}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }
    // [/workbench]

  protected:
    void record(Frame& frame) override;
    void record_view(Frame& frame, const View& view) override;

  private:
    LightList all_lights(const Frame& frame);
    LightsWithScattered all_lights_;
    const Macros all_{{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}};
    SurfacePipelines surface_{{.fragment = "14_environment/surface.frag"}};
    Pipeline seen_ = compute({.shader = "14_environment/surface_seen.comp"});
    SurfacePipelines glass_ = see_through("14_environment/surface.frag", all_);
    SurfacePipelines write_{{.fragment = "18_playground/write.frag"}};
    SurfacePipelines rest_{{.fragment = "18_playground/rest.frag", .depth_write = false, .macros = all_}};
};

}  // namespace lightwalk
