#include "07_mipmaps/coverage.h"

namespace lightwalk {
namespace {

struct CoverageBlock {
    int level, levels;
    float cutoff;
};

}  // namespace

void Coverage::record(Frame& frame, const ImageView& image, float cutoff) {
    const uint32_t words = 256 * image.mips * image.layers;
    if (counts_.bytes < sizeof(uint32_t) * words) {
        counts_ = Buffer(frame.gpu.device, {.name = "alpha counts", .bytes = sizeof(uint32_t) * words});
        factors_ = Buffer(frame.gpu.device, {.name = "alpha factors", .bytes = sizeof(float) * words / 256});
    }
    ComputeAccess access{.reads = {counts_, factors_}, .writes = {counts_, factors_}, .with = {}};
    for (uint32_t m = 0; m < image.mips; ++m) {
        access.reads.push_back(plain_level(image, m));
        if (m > 0) access.writes.push_back(plain_level(image, m));
    }
    const auto threads = [&](uint32_t m) { return glm::uvec3(glm::uvec2(image.mip(m).size()), image.layers); };
    frame.compute("coverage", access, [&](Compute& pass) {
        CoverageBlock block{0, static_cast<int>(image.mips), cutoff};
        pass.use(clear_).set("words", counts_).dispatch_threads(glm::uvec2(words, 1)).wait();
        pass.use(count_).set("alpha_count", counts_).set("factors", factors_);
        for (uint32_t m = 0; m < image.mips; ++m) {
            block.level = static_cast<int>(m);
            pass.set("coverage", block)
                .set("source", plain_level(image, m), nearest_clamp)
                .dispatch_threads(threads(m));
        }
        pass.wait().use(find_).set("alpha_count", counts_).set("factors", factors_).set("coverage", block);
        pass.dispatch({image.mips, image.layers, 1}).wait();
        const bool halves = image.format == VK_FORMAT_R16G16B16A16_SFLOAT;
        const Macros result{{"RESULT_FORMAT", halves ? "rgba16f" : "rgba8"}};
        pass.use(scale_, result).set("alpha_count", counts_).set("factors", factors_);
        for (uint32_t m = 1; m < image.mips; ++m) {
            block.level = static_cast<int>(m);
            pass.set("coverage", block).set("result", plain_level(image, m)).dispatch_threads(threads(m));
        }
    });
}

}  // namespace lightwalk
