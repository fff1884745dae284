// Mip levels of normal maps, on the CPU, and of cutouts, on the GPU.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// Image of four floats a texel, 0 to 1, rows from the top; colours linear.
struct Level {
    glm::uvec2 size{1};
    std::vector<glm::vec4> texels;
};

/// Mip levels of a normal map. Texel: mean normal at unit length, coded as 0.5 + 0.5 n; alpha: square root of 1 -
/// length of the mean. Normals that cancel: (0, 0, 1).
std::vector<Level> normal_levels(const Level& codes);

/// Mip levels with colours weighted by alpha. `cutoff` above 0: each level's alpha is scaled so that the share of
/// texels with at least that alpha, in 8 bits, matches level 0 as closely as the texel count allows (04.alpha_scale).
/// Waits.
std::vector<Level> cutout_levels(Gpu& gpu, const Level& colors, float cutoff);

/// Share of texels with an alpha of at least `cutoff`.
double coverage(const Level& level, float cutoff);

}  // namespace lightwalk
