// Noise tiles that repeat without a seam.
#pragma once
#include <vector>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// side × side thresholds (0.5 + rank) / side², each once and evenly spread at every level: R. A. Ulichney, "The void-
/// and-cluster method for dither array generation", 1993. side is 4 to 128. The same on every machine.
std::vector<float> blue_noise(int side);

/// side × side numbers of mean 0 and variance 1/3, as white grain has, in clumps of about three pixels, as silver has.
std::vector<float> film_clumps(int side);

/// As a square image of single floats.
Image upload_tile(Gpu& gpu, const std::string& name, const std::vector<float>& tile);

}  // namespace lightwalk
