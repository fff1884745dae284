// Sun shadow module: the shadow that houses and objects cast in the light of an atmosphere's sun.
#pragma once
#include "05_shadow_maps/casting.h"
#include "10_atmosphere/atmosphere.h"

namespace lightwalk {

struct SunShadow;

/// A drawing that is shaded by houses and by the scene's objects.
struct SunReceiver {
    const SunShadow* shadowed_by = nullptr;  ///< set by SunShadow::record(); null: nothing casts
};

/// Chapter 05's cascades for the atmosphere's sun. record() for a view: its mirror image reads the same maps. Who casts and
/// who receives is asked of the drawings. The ground's shadow on itself is its own (land.shadow).
struct SunShadow : Module {
    SunShadow(Module& owner, std::string name, const Atmosphere& atmosphere);

    Shadow maps{*this, "maps"};

    void record(Frame& frame, const View& view, const Scene& scene, const Drawings& drawings);
    /// False: the sun is down, nothing casts, or the method is none. Then nothing is recorded, and nothing may read it.
    bool exists() const { return exists_; }

  private:
    const Atmosphere& atmosphere_;
    bool exists_ = false;
};

/// Adds the shadow's maps to a pass. False: there are none, and its shaders include no_sun_shadow.glsl.
bool add_shadow(const SunShadow* shadow, std::vector<With>& with);

}  // namespace lightwalk
