// Landscape world: endless terrain under chapter 10's air and in its fog.
#pragma once
#include "10_atmosphere/planet.h"
#include "11_fractals/terrain.h"
#include "common/app/world.h"

namespace lightwalk {

struct Landscape : World {
    explicit Landscape(Module& owner) : World(owner) { terrain.own_sky = false; }
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    HeightFog fog{*this, "fog"};
    Terrain terrain{*this, "terrain"};

    Drawings drawings() override { return {terrain, sky, atmosphere, fog}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }
};

}  // namespace lightwalk
