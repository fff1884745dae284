#include "12_skin/spread.h"

namespace lightwalk {
namespace {

void make(Frame& frame, Image& image, const char* name, glm::uvec2 size, VkFormat format) {
    const Image::Desc desc{.name = name, .format = format, .size = size};
    image.ensure(frame.gpu.device, desc);
}

}  // namespace

// [record]
void Spread::record(Frame& frame, const Maps& maps, int gaussians) {
    exactly_ = gaussians == 0;
    if (exactly_) return record_exactly(frame, maps);
    constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT;
    const glm::uvec2 size = maps.irradiance.desc.size;
    const std::vector<Gaussian> sum = gaussians_of(gaussians);
    make(frame, between_, "skin between", size, half4);
    make(frame, sum_, "skin sum", size, half4);
    levels_.resize(sum.size());
    std::vector<const Image*> levels;
    for (Image& level : levels_) {
        make(frame, level, "skin level", size, half4);
        levels.push_back(&level);
    }

    // 1. Each Gaussian from the one before it. Levels that an answer leaves out are black.
    if (!Exercises::uses_solution("12.blur_irradiance"))
        for (const Image& level : levels_) frame.fill("skin no level", level, glm::vec4(0));
    blur_irradiance(frame, {.line = sum.size() == 1 ? line_per_channel_ : line_,
                            .irradiance = maps.irradiance,
                            .stretch = maps.stretch,
                            .between = between_,
                            .levels = levels,
                            .sum = sum});

    // 2. Their sum, for each channel with its own weights.
    SkinSum parts{.weight = {}, .count = static_cast<uint32_t>(sum.size())};
    for (size_t i = 0; i < sum.size(); ++i) parts.weight[i] = sum[i].weight;
    ComputeAccess access{.reads = {}, .writes = {sum_}};
    for (const Image& level : levels_) access.reads.push_back(level);
    frame.compute("skin sum", access, [&](Compute& pass) {
        const std::vector<ImageView> views(levels_.begin(), levels_.end());
        pass.use(add_up_).set("levels", views, nearest_clamp).set("sum_of", parts).set("result", sum_);
        pass.dispatch_threads(size);
    });
}
// [/record]

void Spread::record_exactly(Frame& frame, const Maps& maps) {
    make(frame, exact_, "skin exact", maps.irradiance.desc.size, VK_FORMAT_R32G32B32A32_SFLOAT);
    frame.compute("skin exact", {.reads = {maps.irradiance, maps.stretch, maps.position}, .writes = {exact_}},
                  [&](Compute& pass) {
                      pass.use(every_texel_).set("from", maps.irradiance, nearest_clamp).set("result", exact_);
                      pass.set("stretch", maps.stretch, nearest_clamp);
                      pass.set("skin_position", maps.position, nearest_clamp).dispatch_threads(exact_.desc.size);
                  });
}

}  // namespace lightwalk
