// Mip levels of normal maps, on the CPU.
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

}  // namespace lightwalk
