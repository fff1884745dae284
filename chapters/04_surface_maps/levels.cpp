#include "04_surface_maps/levels.h"

#include <algorithm>
#include <cmath>

namespace lightwalk {
namespace {

// The means of two by two texels. Of an odd size the last column or row is left out, as by a blit.
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
    // Means are taken of means, so that a level's length is that of all normals below it.
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

double coverage(const Level& level, float cutoff) {
    const auto count =
        std::count_if(level.texels.begin(), level.texels.end(), [&](const auto& t) { return t.a >= cutoff; });
    return static_cast<double>(count) / static_cast<double>(level.texels.size());
}

std::vector<Level> cutout_levels(const Level& colors, float cutoff) {
    std::vector<Level> levels{colors};
    while (!is_last(levels.back()))
        levels.push_back(halved(levels.back(), [](auto a, auto b, auto c, auto d) {
            const float alpha = a.a + b.a + c.a + d.a;
            const glm::vec4 weighted = a * a.a + b * b.a + c * c.a + d * d.a, plain = 0.25f * (a + b + c + d);
            return glm::vec4(alpha > 0.0f ? glm::vec3(weighted) / alpha : glm::vec3(plain), 0.25f * alpha);
        }));
    if (cutoff < 0.0f) return levels;
    const double wanted = coverage(colors, cutoff);
    for (size_t i = 1; i < levels.size(); ++i) {
        // The alpha that as many texels reach as should is scaled to the cutoff.
        std::vector<float> alphas;
        for (const glm::vec4& texel : levels[i].texels) alphas.push_back(texel.a);
        std::sort(alphas.begin(), alphas.end(), std::greater<>());
        const auto count = static_cast<size_t>(std::lround(wanted * static_cast<double>(alphas.size())));
        const float reached = count == 0 ? alphas[0] * 1.001f : alphas[count - 1];
        // Just above the cutoff, so that rounding to 8 bits does not lose the texel.
        const float scale = reached > 0.0f ? (cutoff + 0.002f) / reached : 1.0f;
        for (glm::vec4& texel : levels[i].texels) texel.a = std::min(1.0f, texel.a * scale);
    }
    return levels;
}

}  // namespace lightwalk
