// Portrait world: a head under lights, in an environment.
#pragma once
#include "12_skin/head.h"
#include "common/app/world.h"

namespace lightwalk {

// [portrait]
struct Portrait : World {
    explicit Portrait(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }

    LitScene objects{*this, "objects", Shading{}};  // its lights and maps; only the head is drawn
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};
    Knob<float> dolly{*this, "dolly", 1.0f, {0.2f, 64.0f}, "Scale factor for the distance of the camera"};

    Drawings drawings() override { return {head}; }
    Eye eye(const Frame&, const Camera& given) override {
        Camera there = given;
        there.position = glm::mix(given.target, given.position, dolly.value);
        return {there};
    }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }
};
// [/portrait]

}  // namespace lightwalk
