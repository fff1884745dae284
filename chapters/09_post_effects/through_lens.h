// World through a lens: chapter 06's objects with depth of field.
#pragma once
#include "06_deferred/deferred_scene.h"
#include "09_post_effects/depth_of_field.h"
#include "common/app/world.h"

namespace lightwalk {

struct ThroughLens : World {
    explicit ThroughLens(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }
    DepthOfField dof{*this, "dof"};
    DeferredScene objects{*this, "objects"};

    Drawings drawings() override { return {objects}; }
    glm::vec4 background() const override { return {glm::vec3(World::background()), 0.0f}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }

  protected:
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override {
        dof.record(frame, view, canvas, drawings());
    }
};

}  // namespace lightwalk
