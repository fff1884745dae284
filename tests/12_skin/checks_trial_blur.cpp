// The chains of 12.blur_irradiance, on a validated device, whose lines add up what they were told.
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "12_skin/exercises.h"
#include "common/check/guard.h"
#include "common/check/trial_device.h"
#include "trials.h"

namespace lightwalk {
namespace {

const char* const line_source = R"(
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

glm::vec4 texel_of(Gpu& gpu, const Image& image, size_t at) {
    const auto texels = gpu.read_back(image);
    uint64_t texel = 0;
    std::memcpy(&texel, &texels[8 * at], 8);
    return glm::unpackHalf4x16(texel);
}

void fill(Frame& frame, const Image& image, glm::vec4 value) {
    const std::vector<uint64_t> texels(size_t(image.desc.size.x) * image.desc.size.y, glm::packHalf4x16(value));
    frame.upload(image.desc.name, image, std::as_bytes(std::span(texels)));
}

}  // namespace

SkinChain try_blur_irradiance(int count) {
    SkinChain seen;
    Gpu gpu(trial_device(seen.validation));
    const Pipeline line = compute({.shader = "the line of the check", .source = line_source});
    Frame frame(gpu);
    const std::vector<Gaussian> sum = gaussians_of(count);
    const glm::uvec2 size(20, 12);
    const auto image = [&](const char* name) { return Image(gpu.device, {.name = name, .size = size}); };
    const Image irradiance = image("irradiance"), stretch = image("stretch"), between = image("between");
    std::vector<Image> levels;
    for (size_t i = 0; i < sum.size(); ++i) levels.push_back(image("level"));
    std::vector<const Image*> pointers;
    for (const Image& level : levels) pointers.push_back(&level);
    frame.begin({4, 4}, 0.0f);
    fill(frame, irradiance, glm::vec4(0)), fill(frame, stretch, glm::vec4(0.25f));
    fill(frame, between, glm::vec4(0, 0, 0, -9));
    for (const Image& level : levels) fill(frame, level, glm::vec4(0, 0, 0, -9));
    guard_call("blur_irradiance");
    try {
        blur_irradiance(frame, {line, irradiance, stretch, between, pointers, sum});
    } catch (const std::exception& e) { seen.error = *e.what() ? e.what() : "blur_irradiance threw an exception"; }
    guard_call("");
    frame.end();
    if (!seen.error.empty()) return seen;
    for (const PassTime& pass : frame.times) seen.passes += pass.name == "skin blur" && pass.stage == "compute";
    for (const Image& level : levels)
        for (const size_t at : {size_t(0), size_t(size.x) * size.y - 1})
            seen.levels.push_back(texel_of(gpu, level, at));
    seen.irradiance = texel_of(gpu, irradiance, 0);
    return seen;
}

}  // namespace lightwalk
