// Mip levels of cutouts, on the GPU.
#pragma once
#include "04_surface_maps/levels.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

/// All levels down to 1×1: colours averaged by alpha. With `cutoff` above 0 each level's alpha is then multiplied so
/// that the share of texels with at least that alpha, in 8 bits, is the first level's, as near as so many texels can be
/// (04.alpha_scale). Waits.
std::vector<Level> cutout_levels(Gpu& gpu, const Level& colors, float cutoff);

/// Share of texels with an alpha of at least `cutoff`.
double coverage(const Level& level, float cutoff);

}  // namespace lightwalk
