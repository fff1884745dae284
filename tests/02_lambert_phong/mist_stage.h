// Test stage of 02.record_mist: images, pipelines and a scene of one quad, over leftovers of the previous frame.
#pragma once
#include "02_lambert_phong/exercises.h"
#include "common/check/recorded.h"
#include "common/check/trial_device.h"

namespace lightwalk {

/// Two frames of 16x16 pixels: the scene, as red as it says, covers the left half, then the right one, at depth 0.5;
/// the sky is blue; mist adds green by the depth that it finds. Before each, a pass leaves the nearest depth and dark
/// green.
struct MistStage {
    MistStage(float red, float blue, PassListener* listener = nullptr)
        : red_(red), blue_(blue), frame(gpu, {.listener = listener, .shows_discarded = true}) {
        cast.images = {&frame.hdr, &frame.depth};
        cast.pipelines = {&sky, &mist};
        cast.calls = {[this](Raster& pass) { draw(pass); }};
    }

    void begin(bool scene_is_right) {
        right_ = scene_is_right;
        draws = 0;
        frame.begin({16, 16}, 0.0f);
        frame.raster("before",
                     {.color = {clear(frame.hdr, glm::vec4(0, 0.5f, 0, 1))}, .depth = clear(frame.depth, 1.0f)},
                     [](Raster&) {});
    }

  private:
    static constexpr const char* sky_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), vec4(0.0, 0.0, BLUE, 1.0)); }
)";
    static constexpr const char* mist_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    imageStore(result, pixel, imageLoad(result, pixel) + vec4(0.0, texelFetch(depth, pixel, 0).r, 0.0, 0.0));
}
)";
    struct Quad {
        glm::vec4 rectangle;
        float depth = 0.5f, depth_right = 0.5f;
    };
    struct Paint {
        glm::vec4 first, second;
    };

    void draw(Raster& pass) {
        ++draws;
        pass.use(quad_).set("quad", Quad{right_ ? glm::vec4(0, -1, 1, 1) : glm::vec4(-1, -1, 0, 1)});
        pass.set("paint", Paint{glm::vec4(red_, 0, 0, 1), glm::vec4(red_, 0, 0, 1)}).draw(6);
    }

    const float red_, blue_;
    bool right_ = false;

  public:
    std::string validation;  ///< its first message
    Gpu gpu{trial_device(validation)};
    const Pipeline sky =
        compute({.shader = "the sky of the check", .macros = {{"BLUE", std::to_string(blue_)}}, .source = sky_source});
    const Pipeline mist = compute({.shader = "the mist of the check", .source = mist_source});
    Frame frame;
    Cast cast;
    int draws = 0;  ///< of the scene, in this frame

  private:
    const Pipeline quad_ = graphics({.vertex = "../tests/common/shaders/quad.vert",
                                     .fragment = "../tests/common/shaders/paint_one.frag",
                                     .cull = VK_CULL_MODE_NONE});
};

}  // namespace lightwalk
