// World of many lights: surfaces through a G-buffer, and screens that show the scene from elsewhere.
#pragma once
#include "03_attenuation/scattered_lights.h"
#include "06_deferred/deferred_scene.h"
#include "06_deferred/screens.h"
#include "06_deferred/town.h"
#include "common/app/world.h"

namespace lightwalk {

// [many_lights]
struct ManyLights : World {
    explicit ManyLights(Module& owner) : World(owner) {
        objects.surfaces.all_lights = [this](const Frame& frame) { return all_lights(frame); };
        objects.surfaces.drawn = [this] { return screens.batches(scene()); };
        objects.shading.with = {screens};
    }
    Town town{*this, "town"};  // declared first: other modules prepare its objects
    DeferredScene objects{*this, "objects"};
    Screens screens{*this, "screens"};
    ScatteredLights scattered{*this};
    Knob<bool> moving{*this, "moving", false, "Animation of the point and spot lights"};

    bool animated() const override { return moving; }
    Drawings drawings() override { return {objects}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }

  protected:
    // Pictures of the scene's screens, from other cameras, shaded forward.
    void record(Frame& frame) override {
        screens.record(frame, scene(),
                       [&](const View& from, Canvas& into) { objects.lit.draw_lit(frame, from, into); });
    }

    virtual LightList all_lights(const Frame& frame) {
        return scattered.all(frame.seed, moving ? std::optional(frame.time_s) : std::nullopt);
    }
};
// [/many_lights]

}  // namespace lightwalk
