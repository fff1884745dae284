// Surroundings world: objects and a sphere in the light of a picture around them.
#pragma once
#include "14_environment/backdrop.h"
#include "14_environment/beat_sphere.h"
#include "14_environment/lit_around.h"
#include "14_environment/probe.h"
#include "common/app/world.h"

namespace lightwalk {

// [surroundings]
struct Surroundings : World {
    /// `heard`: the sphere's music; null: the scene's own.
    explicit Surroundings(Module& owner, Music* heard = nullptr);

    ImageLight light{*this, "environment"};
    Backdrop backdrop{*this, "backdrop", light};
    LitAround objects{*this, "objects", light};
    Music music{*this, "music"};
    BeatSphere sphere;
    SceneProbe probe{*this, "probe"};

    Drawings drawings() override { return {backdrop, objects, sphere}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }
    // [/surroundings]

  protected:
    void record(Frame& frame) override;
};

}  // namespace lightwalk
