// Mip levels of cutouts, on the GPU.
#pragma once
#include "04_surface_maps/levels.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

/// Mip levels with colours weighted by alpha. `cutoff` above 0: each level's alpha is scaled so that the share of
/// texels with at least that alpha, in 8 bits, matches level 0 as closely as the texel count allows (04.alpha_scale).
/// Waits.
std::vector<Level> cutout_levels(Gpu& gpu, const Level& colors, float cutoff);

/// Share of texels with an alpha of at least `cutoff`.
double coverage(const Level& level, float cutoff);

}  // namespace lightwalk
