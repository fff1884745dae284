// Portrait world: a head under lights, in an environment.
#pragma once
#include "12_skin/head.h"
#include "common/app/world.h"

namespace lightwalk {

// [portrait]
struct Portrait : World {
    explicit Portrait(Module& owner) : World(owner) {
        objects.maps.method.change_default("normal");
        objects.shaded.reset();  // the skin shades them
    }

    LitScene objects{*this, "objects"};  // its lights and maps; only the head is drawn
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};

    Drawings drawings() override { return {head}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }
};
// [/portrait]

}  // namespace lightwalk
