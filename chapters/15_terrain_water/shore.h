// Shore world: terrain, a city, objects and water under a sky.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "14_environment/probe.h"
#include "15_terrain_water/city.h"
#include "15_terrain_water/reflected_rays.h"
#include "15_terrain_water/sun_shadow.h"
#include "15_terrain_water/transparency.h"
#include "common/app/world.h"

namespace lightwalk {

// [shore]
struct Shore : World {
    explicit Shore(Module& owner);

    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Ground ground{*this, "ground"};
    Land land{*this, "land", ground, atmosphere};
    City city{*this, "city", ground, atmosphere};
    SunShadow sun_shadow{*this, "sun_shadow", atmosphere};
    LitScene objects{*this, "objects"};
    ImageLight light{*this, "environment"};
    SceneProbe probe{*this, "probe"};
    Water water{*this, "water", light};
    ReflectedRays reflected{*this, "reflected", ground, land, city, atmosphere};
    Transparency transparency{*this, "transparency"};
    HeightFog fog{*this, "fog"};

    Drawings drawings() override { return {land, city, objects, sky, water, atmosphere, fog}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }
    // [/shore]

  protected:
    void record(Frame& frame) override;
    void record_view(Frame& frame, const View& view) override;
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override;
};

}  // namespace lightwalk
