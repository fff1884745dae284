#include "06_deferred/depth_pyramid.h"

#include <algorithm>
#include <bit>

#include "06_deferred/culling_data.h"

namespace lightwalk {

// [pyramid_record]
void DepthPyramid::record(Frame& frame, const ImageView& depth) {
    pixels_ = depth.size();
    const glm::uvec2 half = glm::max(pixels_ / 2u, 1u);
    const auto levels = static_cast<uint32_t>(std::bit_width(std::max(half.x, half.y)));
    image_.ensure(frame.gpu.device,
                  {.name = name_, .format = VK_FORMAT_R32_SFLOAT, .size = half, .mips = levels, .kept = true});
    const ImageView all(image_);
    frame.compute("depth pyramid", {.reads = {depth, all}, .writes = {all}}, [&](Compute& pass) {
        pass.use(five_levels_);
        for (uint32_t first = 0; first < levels; first += PYRAMID_STEP) {
            if (first > 0) pass.wait();  // for the level before
            const ImageView source = first > 0 ? all.mip(first - 1) : depth;
            std::vector<ImageView> made;
            for (uint32_t m = first; m < std::min(levels, first + PYRAMID_STEP); ++m) made.push_back(all.mip(m));
            pass.set("source", source, nearest_clamp).set("level", std::span<const ImageView>(made));
            pass.set("pyramid_step", static_cast<int>(made.size()));
            const glm::uvec2 groups = glm::max(glm::uvec2(source.size()) >> PYRAMID_STEP, 1u);
            pass.dispatch({groups, 1});
        }
    });
}
// [/pyramid_record]

}  // namespace lightwalk
