// Surfaces world: a scene's objects with their maps under its lights, without shadows.
#pragma once
#include "04_surface_maps/surface_scene.h"
#include "common/app/world.h"

namespace lightwalk {

struct Surfaces : World {
    explicit Surfaces(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }
    SurfaceScene objects{*this, "objects"};

    Drawings drawings() override { return {objects}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"post.tone", "off"}}; }
};

}  // namespace lightwalk
