// Julia set world: a Julia set in an environment.
#pragma once
#include "11_fractals/julia.h"
#include "common/app/world.h"

namespace lightwalk {

struct JuliaSet : World {
    using World::World;
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};

    Drawings drawings() override { return {julia}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "film"}};
    }
};

}  // namespace lightwalk
