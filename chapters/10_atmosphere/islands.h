// Islands world: mountains on a planet, in its air and fog.
#pragma once
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/mountains.h"
#include "common/app/world.h"

namespace lightwalk {

// [islands]
struct Islands : World {
    explicit Islands(Module& owner) : World(owner) { fog.method.change_default("none"); }

    Atmosphere atmosphere{*this, "atmosphere"};
    Planet planet{*this, "planet", atmosphere};
    Mountains mountains{*this, "mountains", atmosphere, planet};
    HeightFog fog{*this, "fog"};

    Drawings drawings() override { return {mountains, planet, atmosphere, fog}; }
    glm::vec4 background() const override { return {0.0f, 0.0f, 0.0f, 1.0f}; }  // space
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "film"}};
    }
};
// [/islands]

}  // namespace lightwalk
