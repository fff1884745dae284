// Test stage of 12.blur_irradiance: a chain of images, and lines that record their arguments.
#pragma once
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "12_skin/exercises.h"
#include "common/check/recorded.h"
#include "common/check/trial_device.h"

namespace lightwalk {

/// A chain of `count` Gaussians over 20x12 texels. Each line adds half of its variance argument to red, green and
/// blue, so that both directions together add all of it; and to alpha 1 for u, 32 for v, 1024 for a smooth_mm that
/// differs from the texels', 4096 for a wrong stretch. Levels held -9 in alpha before.
struct BlurStage {
    explicit BlurStage(int count, PassListener* listener = nullptr)
        : sum(gaussians_of(count)), frame(gpu, {.listener = listener}) {
        for (size_t i = 0; i < sum.size(); ++i) levels.push_back(image("level"));
        for (const Image& level : levels) pointers.push_back(&level);
        cast.images = {&irradiance, &stretch, &between};
        cast.images.insert(cast.images.end(), pointers.begin(), pointers.end());
        cast.pipelines = {&line};
    }

    void begin() {
        frame.begin({4, 4}, 0.0f);
        fill(irradiance, glm::vec4(0));
        fill(stretch, glm::vec4(0.25f));
        fill(between, glm::vec4(0, 0, 0, -9));
        for (const Image& level : levels) fill(level, glm::vec4(0, 0, 0, -9));
    }

    glm::vec4 texel_of(const Image& of, size_t at) {
        const auto texels = gpu.read_back(of);
        uint64_t texel = 0;
        std::memcpy(&texel, &texels[8 * at], 8);
        return glm::unpackHalf4x16(texel);
    }

  private:
    static constexpr const char* line_source = R"(
#include "12_skin/profile.h"
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from, stretch;
layout(rgba16f) writeonly uniform image2D into;
layout(scalar) uniform SkinBlurBlock { SkinBlur blur; };
void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(into)))) return;
    vec4 own = texelFetch(from, texel, 0);
    vec3 variance = blur.sigma_mm * blur.sigma_mm, before = own.rgb - 0.5 * float(blur.direction.y) * variance;
    float smooth_before = sqrt(max(min(before.x, min(before.y, before.z)), 0.0));
    own.a += float(blur.direction.x) + 32.0 * float(blur.direction.y);
    if (abs(blur.smooth_mm - smooth_before) > 0.02 + 0.02 * smooth_before) own.a += 1024.0;
    if (texelFetch(stretch, texel, 0).x != 0.25) own.a += 4096.0;
    imageStore(into, texel, vec4(own.rgb + 0.5 * variance, own.a));
}
)";

    Image image(const char* name) { return Image(gpu.device, {.name = name, .size = size}); }

    void fill(const Image& with, glm::vec4 value) {
        const std::vector<uint64_t> texels(size_t(size.x) * size.y, glm::packHalf4x16(value));
        frame.upload(with.desc.name, with, std::as_bytes(std::span(texels)));
    }

  public:
    static constexpr glm::uvec2 size{20, 12};
    const std::vector<Gaussian> sum;
    std::string validation;  ///< its first message
    Gpu gpu{trial_device(validation)};
    const Pipeline line = compute({.shader = "the line of the check", .source = line_source});
    const Image irradiance = image("irradiance"), stretch = image("stretch"), between = image("between");
    std::vector<Image> levels;
    std::vector<const Image*> pointers;  ///< to those
    Frame frame;
    Cast cast;
};

}  // namespace lightwalk
