// The pass of 11.record_cones, on a validated device, with shaders that write down where they have been.
#include <cstring>

#include "11_fractals/exercises.h"
#include "common/app/module.h"
#include "common/check/guard.h"
#include "common/check/trial_device.h"
#include "trials.h"

namespace lightwalk {
namespace {

const char* const cone_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) writeonly uniform image2D starts;
layout(scalar) uniform NumberBlock { float number; };
void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, imageSize(starts)))) return;
    imageStore(starts, tile, vec4(number, tile, gl_NumWorkGroups.x * gl_NumWorkGroups.y));
}
)";

const char* const march_source = R"(
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
    void bind(Pass& pass) const override { pass.offer("number", number); }
};

std::vector<glm::vec4> texels_of(Gpu& gpu, const Image& image) {
    const auto bytes = gpu.read_back(image);
    std::vector<glm::vec4> texels(bytes.size() / sizeof(glm::vec4));
    std::memcpy(texels.data(), bytes.data(), texels.size() * sizeof(glm::vec4));
    return texels;
}

void forget(Frame& frame, const Image& image) {
    const std::vector<glm::vec4> texels(size_t(image.desc.size.x) * image.desc.size.y, glm::vec4(-9));
    frame.upload(image.desc.name, image, std::as_bytes(std::span(texels)));
}

}  // namespace

ConesSeen try_record_cones(glm::ivec2 size) {
    ConesSeen seen;
    Gpu gpu(trial_device(seen.validation));
    const Pipeline cone = compute({.shader = "the cones of the check", .source = cone_source});
    const Pipeline march = compute({.shader = "the rays of the check", .source = march_source});
    const auto image = [&](const char* name, glm::uvec2 texels) {
        return Image(gpu.device, {.name = name, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = texels});
    };
    const Image starts = image("starts", glm::uvec2(size + 7) / 8u), found = image("found", size);
    Owner owner;
    Numbered now(owner, "now");
    Frame frame(gpu);
    for (const float number : {1.0f, 2.0f}) {
        now.number = number;
        frame.begin(glm::uvec2(size), 0.0f);
        forget(frame, starts), forget(frame, found);
        guard_call("record_cones");
        try {
            record_cones(frame, {cone, march, starts, found, {now}});
        } catch (const std::exception& e) { seen.error = *e.what() ? e.what() : "record_cones threw an exception"; }
        guard_call("");
        frame.end();
        if (!seen.error.empty()) return seen;
    }
    for (const PassTime& pass : frame.times)
        if (pass.stage == "compute") seen.passes += (seen.passes.empty() ? "" : ", ") + pass.name;
    seen.starts = texels_of(gpu, starts), seen.found = texels_of(gpu, found);
    return seen;
}

}  // namespace lightwalk
