#include "04_surface_maps/levels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/gpu/frame.h"

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

namespace {

const Pipeline halve = compute({.shader = "04_surface_maps/halve_cutout.comp"});
const Pipeline keep_coverage = compute({.shader = "04_surface_maps/keep_coverage.comp"});

struct Cutout {
    float cutoff, wanted;
};

}  // namespace

double coverage(const Level& level, float cutoff) {
    const auto count =
        std::count_if(level.texels.begin(), level.texels.end(), [&](const auto& t) { return t.a >= cutoff; });
    return static_cast<double>(count) / static_cast<double>(level.texels.size());
}

std::vector<Level> cutout_levels(Gpu& gpu, const Level& colors, float cutoff) {
    const Image chain(gpu.device, {.name = "cutout",
                                   .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                   .size = colors.size,
                                   .mips = full_mip_count(colors.size)});
    const uint32_t mips = chain.desc.mips;
    std::vector<ReadBack> texels(mips);
    Frame frame(gpu);
    frame.begin({1, 1}, 0.0f);
    frame.upload("cutout", chain.mip(0), std::as_bytes(std::span(colors.texels)));

    // 1. Each level from the previous one.
    frame.compute("halve", {.reads = {chain}, .writes = {chain}}, [&](Compute& pass) {
        pass.use(halve);
        for (uint32_t m = 1; m < mips; ++m, pass.wait())
            pass.set("finer", chain.mip(m - 1), nearest_clamp)
                .set("coarser", chain.mip(m))
                .dispatch_threads(chain.mip(m).size());
    });

    // 2. Alpha of each level, independently.
    if (cutoff > 0.0f)
        frame.compute("keep_coverage", {.reads = {chain}, .writes = {chain}}, [&](Compute& pass) {
            pass.use(keep_coverage).set("cutout", Cutout{cutoff, static_cast<float>(coverage(colors, cutoff))});
            for (uint32_t m = 1; m < mips; ++m) pass.set("level", chain.mip(m)).dispatch({1, 1, 1});
        });

    for (uint32_t m = 0; m < mips; ++m) frame.read_back(chain.mip(m), texels[m]);
    frame.end();
    std::vector<Level> levels;
    for (uint32_t m = 0; m < mips; ++m) levels.push_back({glm::uvec2(chain.mip(m).size()), texels[m].as<glm::vec4>()});
    return levels;
}

}  // namespace lightwalk
