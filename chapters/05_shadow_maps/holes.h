// Dependencies of shadows of surfaces with holes.
#pragma once
#include "04_surface_maps/maps.h"

namespace lightwalk {

/// Another number where textures cut other holes, or the same ones elsewhere because they move.
uint64_t holes_cut(const Maps& maps, const Scene& scene, float time_s);

}  // namespace lightwalk
