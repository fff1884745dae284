// Shadows between drawings: some cast them, some receive them.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/shadow.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [casting]
/// A drawing that casts shadows and is no item of the scene, such as a city. Owners of shadow maps find it in the list that
/// is drawn.
struct Caster {
    virtual ~Caster() = default;
    virtual Bounds bounds() const = 0;    ///< of all that casts, world space; empty: nothing
    virtual uint64_t placed() const = 0;  ///< another number where that has changed
    virtual std::vector<With> shadow_modules() const = 0;
    virtual void cast(Raster& pass, const View& light) const = 0;
};

/// A drawing of the scene's items, with maps that cut holes into them.
struct ItemCaster {
    virtual ~ItemCaster() = default;
    virtual const Maps& cut_by() const = 0;
};

/// Everything that casts shadows among some drawings.
class Casting {
  public:
    Casting() = default;
    explicit Casting(const Drawings& drawings);

    /// Casters beside the scene's items, for the maps of a Shadow.
    void add_to(Shadow::Casters& casters) const;

    /// Maps that cut holes into the scene's items; null: no drawing has any.
    const Maps* maps() const { return maps_; }

  private:
    std::vector<const Caster*> others_;
    const Maps* maps_ = nullptr;
};
// [/casting]

}  // namespace lightwalk
