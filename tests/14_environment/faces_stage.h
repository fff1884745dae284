// Test stage of 14.prefilter_faces: two cubes, a module, and a filter that writes down where it has been.
#pragma once
#include "14_environment/exercises.h"
#include "common/app/module.h"
#include "common/check/recorded.h"
#include "common/check/trial_device.h"

namespace lightwalk {

/// Frames with a cube of that many texels and levels, filled with -9 before each. The filter writes (1 + face,
/// roughness, groups of threads, the frame's light from `radiance`).
struct FacesStage {
    FacesStage(uint32_t texels, uint32_t levels, PassListener* listener = nullptr)
        : texels_(texels), levels_(levels), frame(gpu, {.listener = listener}) {
        cast.images = {&radiance, &prefiltered};
        cast.pipelines = {&filter};
        cast.given = {&giving};
    }

    void begin(float light) {
        frame.begin({8, 8}, 0.0f);
        fill(radiance, light);
        fill(prefiltered, -9.0f);
    }

  private:
    static constexpr const char* filter_source = R"(
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
        void bind(Pass& pass) const override { pass.set_if_present("given", 0.0f); }
    };

    Image cube(const char* name) {
        return Image(gpu.device, {.name = name,
                                  .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                  .size = {texels_, texels_},
                                  .mips = levels_,
                                  .layers = 6,
                                  .cube = true});
    }

    void fill(const Image& of, float value) {
        for (uint32_t m = 0; m < of.desc.mips; ++m) {
            const ImageView level = of.as_array().mip(m);
            const std::vector<glm::vec4> texels(size_t(level.size().x) * level.size().y * 6, glm::vec4(value));
            frame.upload(of.desc.name, level, std::as_bytes(std::span(texels)));
        }
    }

    const uint32_t texels_, levels_;
    Owner owner_;

  public:
    std::string validation;  ///< its first message
    Gpu gpu{trial_device(validation)};
    const Pipeline filter = compute({.shader = "the filter of the check", .source = filter_source});
    const Image radiance = cube("radiance"), prefiltered = cube("prefiltered");
    Giving giving{owner_, "giving"};
    Frame frame;
    Cast cast;
};

}  // namespace lightwalk
