// Mip levels of normal maps and of cutouts, on the CPU.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

/// Four numbers a texel, 0 to 1, rows from the top; colours linear.
struct Level {
    glm::uvec2 size{1};
    std::vector<glm::vec4> texels;
};

/// All levels down to 1×1, each texel from the mean of the normals below it: x, y and z of the mean made unit length,
/// coded as 0.5 + 0.5 n, and in alpha the root of 1 - the length of the mean. Where normals cancel: (0, 0, 1).
std::vector<Level> normal_levels(const Level& codes);

/// All levels: colours averaged by alpha. With `cutoff` not below 0 each level's alpha is then multiplied so that the
/// share of texels with at least that alpha is the first level's (I. Castaño, "Computing Alpha Mipmaps", 2010).
std::vector<Level> cutout_levels(const Level& colors, float cutoff);

/// The share of texels whose alpha is at least `cutoff`.
double coverage(const Level& level, float cutoff);

}  // namespace lightwalk
