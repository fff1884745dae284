// Shadows between drawings: some cast them, some receive them.
#pragma once
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/shadow.h"
#include "common/app/drawing.h"

namespace lightwalk {

/// Hash of the holes that textures cut, which animated textures move.
uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s);

/// Shadow caster that is not an item of the scene, such as a city. Owners of shadow maps find it among the drawings.
struct Caster {
    virtual ~Caster() = default;
    virtual Bounds bounds() const = 0;    ///< world-space bounds of all casters; empty: none
    virtual uint64_t placed() const = 0;  ///< changes with the casters' positions
    virtual std::vector<With> shadow_modules() const = 0;
    virtual void cast(Raster& pass, const View& light) const = 0;
};

/// Drawing of the scene's items, with maps that cut holes into them.
struct ItemCaster {
    virtual ~ItemCaster() = default;
    virtual const Maps& cut_by() const = 0;
};

/// Shadow casters among drawings.
class Casting {
  public:
    Casting() = default;
    explicit Casting(const Drawings& drawings);

    /// Adds casters other than the scene's items.
    void add_to(Shadow::Casters& casters) const;

    /// Maps that cut holes into the scene's items; null: none.
    const Maps* maps() const { return maps_; }

  private:
    std::vector<const Caster*> others_;
    const Maps* maps_ = nullptr;
};

}  // namespace lightwalk
