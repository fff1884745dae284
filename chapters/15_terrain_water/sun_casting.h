// Sun shadows of drawings: casters and receivers.
#pragma once
#include "common/app/drawing.h"
#include "common/scene/mesh.h"

namespace lightwalk {

struct SunShadow;

// [sun_casting]
/// A drawing that casts shadows and is no item of the scene. SunShadow finds it in the list that is drawn.
struct SunCaster {
    virtual ~SunCaster() = default;
    virtual Bounds bounds() const = 0;    ///< of all that casts, world space; empty: nothing
    virtual uint64_t placed() const = 0;  ///< another number where that has changed
    virtual std::vector<With> casts_with() const = 0;
    virtual void cast(Raster& pass, const View& light) const = 0;
};

/// A drawing that is shaded by these and by the scene's objects.
struct SunReceiver {
    const SunShadow* shadowed_by = nullptr;  ///< set by SunShadow::record(); null: nothing casts
};
// [/sun_casting]

}  // namespace lightwalk
