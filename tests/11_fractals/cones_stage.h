// Test stage of 11.record_cones: two images, a module, and shaders that write down where they have been.
#pragma once
#include <cstring>

#include "11_fractals/exercises.h"
#include "common/app/module.h"
#include "common/check/recorded.h"
#include "common/check/trial_device.h"

namespace lightwalk {

/// Frames of that many pixels, with a texel of `starts` for each 8x8 of them. Before each, both images hold -9. A
/// cone writes (its frame, x, y, groups of threads dispatched), a march its tile's start, with its own groups as the
/// last number.
struct ConesStage {
    explicit ConesStage(glm::ivec2 size, PassListener* listener = nullptr)
        : size_(size), frame(gpu, {.listener = listener}) {
        cast.images = {&starts, &found};
        cast.pipelines = {&cone, &march};
        cast.given = {&now};
    }

    void begin(float number) {
        now.number = number;
        frame.begin(size_, 0.0f);
        for (const Image* image : {&starts, &found}) {
            const std::vector<glm::vec4> texels(size_t(image->desc.size.x) * image->desc.size.y, glm::vec4(-9));
            frame.upload(image->desc.name, *image, std::as_bytes(std::span(texels)));
        }
    }

    std::vector<glm::vec4> texels_of(const Image& image) {
        const auto bytes = gpu.read_back(image);
        std::vector<glm::vec4> texels(bytes.size() / sizeof(glm::vec4));
        std::memcpy(texels.data(), bytes.data(), texels.size() * sizeof(glm::vec4));
        return texels;
    }

  private:
    static constexpr const char* cone_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) writeonly uniform image2D starts;
layout(scalar) uniform NumberBlock { float number; };
void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, imageSize(starts)))) return;
    imageStore(starts, tile, vec4(number, tile, gl_NumWorkGroups.x * gl_NumWorkGroups.y));
}
)";
    static constexpr const char* march_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D starts;
layout(rgba32f) writeonly uniform image2D found;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(found)))) return;
    imageStore(found, pixel, vec4(texelFetch(starts, pixel / 8, 0).xyz, gl_NumWorkGroups.x * gl_NumWorkGroups.y));
}
)";
    struct Owner : Module {};
    struct Numbered : Module {
        using Module::Module;
        float number = 0;
        std::vector<Resource> reads() const override { return {}; }
        void bind(Pass& pass) const override { pass.set_if_present("number", number); }
    };

    Image image(const char* name, glm::uvec2 texels) {
        return Image(gpu.device, {.name = name, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = texels});
    }

    const glm::uvec2 size_;
    Owner owner_;

  public:
    std::string validation;  ///< its first message
    Gpu gpu{trial_device(validation)};
    const Pipeline cone = compute({.shader = "the cones of the check", .source = cone_source});
    const Pipeline march = compute({.shader = "the rays of the check", .source = march_source});
    const Image starts = image("starts", (size_ + 7u) / 8u), found = image("found", size_);
    Numbered now{owner_, "now"};
    Frame frame;
    Cast cast;
};

}  // namespace lightwalk
