// Occlusion of the surroundings' light by objects on a plane below them, as a module.
#pragma once
#include "05_shadow_maps/rays.h"
#include "14_environment/ground_shadow_data.h"
#include "14_environment/image_light.h"
#include "common/base/epoch.h"

namespace lightwalk {

// [ground_shadow]
/// A map of the ground below the scene: of each place the share of the light from all around that is not hidden, found by
/// chapter 05's rays. record() in each frame; it does nothing where nothing has moved.
struct GroundShadow : Module {
    GroundShadow(Module& owner, std::string name) : Module(owner, std::move(name), "ground_shadow") {}

    Knob<int> directions{*this,
                         "directions",
                         96,
                         {1, 1024},
                         "Directions that stand for the environment, each for an equal share of light"};
    Knob<int> resolution{*this, "resolution", 128, {8, 1024}, "Width and height of the map", "texels"};
    SceneRays rays{*this, "rays"};
    Image arriving;  ///< made by record()
    // [/ground_shadow]

    void prepare(Gpu& gpu, Scene& scene) override;
    /// `maps`: those that cut holes into what stands there; null: holes by an alpha below 0.5, at rest.
    void record(Frame& frame, const Scene& scene, const Maps* maps, const EnvironmentScale& turn, float ground_y);
    const GroundShadowState& state() const { return state_; }

  private:
    ImageRgb picture_;
    GroundShadowState state_{};
    Fingerprint made_;
    Buffer lights_;
    Pipeline trace_ = compute({.shader = "14_environment/ground_shadow.comp"});
};

/// So many directions, each of which stands for the same share of the light (its luminance times the cosine to +y) that
/// an equirectangular picture sends down: turned as `turn` says.
std::vector<GroundLight> ground_lights(const ImageRgb& picture, const EnvironmentScale& turn, int count);

}  // namespace lightwalk
