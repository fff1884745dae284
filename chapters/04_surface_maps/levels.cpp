#include "04_surface_maps/levels.h"

#include <algorithm>
#include <cmath>

namespace lightwalk {
namespace {

// Means of 2 × 2 texels; odd sizes drop the last column or row, as blits do.
template <class Mean>
Level halved(const Level& from, Mean mean) {
    Level to{glm::max(from.size / 2u, glm::uvec2(1)), {}};
    const auto at = [&](uint32_t x, uint32_t y) {
        return from.texels[std::min(y, from.size.y - 1) * size_t(from.size.x) + std::min(x, from.size.x - 1)];
    };
    for (uint32_t y = 0; y < to.size.y; ++y)
        for (uint32_t x = 0; x < to.size.x; ++x)
            to.texels.push_back(
                mean(at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1)));
    return to;
}

bool is_last(const Level& level) { return level.size == glm::uvec2(1); }

}  // namespace

std::vector<Level> normal_levels(const Level& codes) {
    // Unnormalised means, so that a level's length is that of all normals below it.
    Level means = codes;
    for (glm::vec4& texel : means.texels) {
        const glm::vec2 xy = 2.0f * glm::vec2(texel) - 1.0f;
        const glm::vec3 normal(xy, std::sqrt(std::max(0.0f, 1.0f - glm::dot(xy, xy))));
        texel = glm::vec4(glm::normalize(normal), 1.0f);
    }
    std::vector<Level> levels;
    while (true) {
        Level& level = levels.emplace_back(means);
        for (glm::vec4& texel : level.texels) {
            const float length = glm::length(glm::vec3(texel));
            const glm::vec3 normal = length > 1e-4f ? glm::vec3(texel) / length : glm::vec3(0, 0, 1);
            texel = glm::vec4(0.5f + 0.5f * normal, std::sqrt(std::clamp(1.0f - length, 0.0f, 1.0f)));
        }
        if (is_last(means)) return levels;
        means = halved(means, [](auto a, auto b, auto c, auto d) { return 0.25f * (a + b + c + d); });
    }
}

}  // namespace lightwalk
