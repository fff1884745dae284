// Mip levels of normal maps, on the CPU.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

/// Image of four floats a texel, 0 to 1, rows from the top; colours linear.
struct Level {
    glm::uvec2 size{1};
    std::vector<glm::vec4> texels;
};

/// Mip levels of a normal map. Texel: mean normal at unit length, coded as 0.5 + 0.5 n; alpha: square root of 1 -
/// length of the mean. Normals that cancel: (0, 0, 1).
std::vector<Level> normal_levels(const Level& codes);

}  // namespace lightwalk
