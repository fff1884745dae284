// Fractal world: a Julia set, or a landscape under a sky of its own.
#pragma once
#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"
#include "common/app/world.h"

namespace lightwalk {

// A Julia set in an environment.
struct JuliaSet : World {
    using World::World;
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};

    Drawings drawings() override { return {julia}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "film"}};
    }
};

struct Fractal : World {
    explicit Fractal(Module& owner) : World(owner) {
        set.julia.in_use = [this] { return subject.is("julia"); };
        terrain.in_use = [this] { return subject.is("terrain"); };
    }

    Choice subject{
        *this, "world", {"julia", "terrain"}, "julia", "Subject of the picture: a Julia set, or a landscape"};
    JuliaSet set{*this};
    Terrain terrain{*this, "terrain"};

    Drawings drawings() override { return subject.is("julia") ? set.drawings() : Drawings{terrain}; }
    Eye eye(const Frame& frame, const Camera& given) override {
        return subject.is("terrain") ? terrain.eye(given, frame.time_s) : Eye{given};
    }
    glm::vec4 background() const override { return {0.0f, 0.0f, 0.0f, 1.0f}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return set.look(); }
};

}  // namespace lightwalk
