// The pass of 14.prefilter_faces, on a validated device, with a shader that writes down where it has been.
#include <cstring>

#include "14_environment/exercises.h"
#include "common/app/module.h"
#include "common/check/guard.h"
#include "common/check/trial_device.h"
#include "trials.h"

namespace lightwalk {
namespace {

const char* const filter_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
uniform samplerCube radiance;
layout(scalar) uniform FaceNowBlock { uint face; float roughness; } face_now;
layout(scalar) uniform GivenBlock { float given; };
layout(rgba32f) writeonly uniform image2D face_level;
void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(face_level)))) return;
    float light = textureLod(radiance, vec3(0.0, 1.0, 0.0), 0.0).r + given;
    float groups = float(gl_NumWorkGroups.x * gl_NumWorkGroups.y);
    imageStore(face_level, texel, vec4(1.0 + float(face_now.face), face_now.roughness, groups, light));
}
)";

struct Owner : Module {};

struct Giving : Module {
    using Module::Module;
    std::vector<Resource> reads() const override { return {}; }
    void bind(Pass& pass) const override { pass.offer("given", 0.0f); }
};

void fill(Frame& frame, const Image& cube, float value) {
    for (uint32_t m = 0; m < cube.desc.mips; ++m) {
        const ImageView level = cube.as_array().mip(m);
        const std::vector<glm::vec4> texels(size_t(level.size().x) * level.size().y * 6, glm::vec4(value));
        frame.upload(cube.desc.name, level, std::as_bytes(std::span(texels)));
    }
}

}  // namespace

FacesSeen try_prefilter_faces(uint32_t texels, uint32_t levels) {
    FacesSeen seen;
    Gpu gpu(trial_device(seen.validation));
    const Pipeline filter = compute({.shader = "the filter of the check", .source = filter_source});
    const auto cube = [&](const char* name) {
        return Image(gpu.device, {.name = name,
                                  .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                  .size = {texels, texels},
                                  .mips = levels,
                                  .layers = 6,
                                  .cube = true});
    };
    const Image radiance = cube("radiance"), prefiltered = cube("prefiltered");
    Owner owner;
    Giving giving(owner, "giving");
    Frame frame(gpu);
    for (const float light : {1.0f, 2.0f}) {
        frame.begin({8, 8}, 0.0f);
        fill(frame, radiance, light), fill(frame, prefiltered, -9.0f);
        guard_call("prefilter_faces");
        try {
            prefilter_faces(frame, {filter, radiance, prefiltered, {giving}});
        } catch (const std::exception& e) { seen.error = *e.what() ? e.what() : "prefilter_faces threw an exception"; }
        guard_call("");
        frame.end();
        if (!seen.error.empty()) return seen;
    }
    for (const PassTime& pass : frame.times)
        if (pass.stage == "compute") seen.passes += (seen.passes.empty() ? "" : ", ") + pass.name;
    for (uint32_t m = 0; m < levels; ++m) {
        const auto bytes = gpu.read_back(prefiltered.as_array().mip(m));
        const size_t before = seen.texels.size();
        seen.texels.resize(before + bytes.size() / sizeof(glm::vec4));
        std::memcpy(seen.texels.data() + before, bytes.data(), bytes.size());
    }
    return seen;
}

}  // namespace lightwalk
