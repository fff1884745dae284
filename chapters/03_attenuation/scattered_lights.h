// Random lights over a scene; equal seeds give equal lights on every machine.
#pragma once
#include <optional>

#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// A number in [0, 1) for each seed, item and `which` of its numbers (below 16).
float scattered_number(unsigned seed, uint32_t item, uint32_t which);

/// `count` point and spot lights (every third one) a little above the bottom of `where`, in world space. The more there
/// are the shorter their range, so that about as many reach a point of the floor.
std::vector<Light> scatter_lights(const Bounds& where, int count, unsigned seed);

/// Takes each point and spot light around a circle of up to half a metre, in 2 s to 6 s. At time 0 it has moved, too.
void move_lights(std::vector<Light>& lights, float time_s);

/// Lights of a scene and random ones: the same list for as long as neither changes.
class LightsWithScattered {
  public:
    /// `count` as in scatter_lights(); `moved_at_s`: moved by move_lights() to this time.
    const LightList& from(const LightList& own, const Bounds& where, int count, unsigned seed,
                          std::optional<float> moved_at_s = {});

  private:
    Fingerprint still_made_, moved_made_;
    LightList own_, still_, moved_;
};

/// The scene's lights and random ones within the scene's initial bounds. Its knob has no prefix.
struct ScatteredLights : Module {
    explicit ScatteredLights(Module& owner);
    Knob<int> count;

    void prepare(Gpu&, Scene& loaded) override {
        scene_ = &loaded;
        where_ = loaded.bounds;
    }
    const LightList& all(unsigned seed, std::optional<float> moved_at_s = {}) {
        return lights_.from(scene_->lights(), where_, count, seed, moved_at_s);
    }

  private:
    const Scene* scene_ = nullptr;
    Bounds where_;
    LightsWithScattered lights_;
};

}  // namespace lightwalk
