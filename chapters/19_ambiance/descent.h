// Descent world: chapter 15's shore below a layer of clouds, for a camera that comes from orbit.
#pragma once
#include "10_atmosphere/cloud_layer.h"
#include "15_terrain_water/shore.h"

namespace lightwalk {

struct Descent : Shore {
    using Shore::Shore;
    CloudLayer clouds{*this, "clouds", atmosphere, sky};

    Drawings drawings() override {
        Drawings all = Shore::drawings();
        all.emplace_back(clouds);
        return all;
    }
};

}  // namespace lightwalk
