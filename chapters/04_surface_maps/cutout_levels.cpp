#include "04_surface_maps/cutout_levels.h"

#include <algorithm>
#include <cstring>

#include "common/gpu/frame.h"

namespace lightwalk {
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

// [cutout_levels]
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
// [/cutout_levels]

}  // namespace lightwalk
