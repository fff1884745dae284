// Dependencies of shadows of surfaces with holes.
#pragma once
#include "04_surface_maps/maps.h"

namespace lightwalk {

/// Hash of the holes that textures cut, which animated textures move.
uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s);

}  // namespace lightwalk
