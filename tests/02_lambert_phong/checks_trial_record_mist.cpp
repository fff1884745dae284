// The two frames of 02.record_mist, on a validated device, over what a frame before has left.
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "02_lambert_phong/exercises.h"
#include "common/check/guard.h"
#include "common/check/trial_device.h"
#include "trials.h"

namespace lightwalk {
namespace {

const char* const sky_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), vec4(0.0, 0.0, BLUE, 1.0)); }
)";
const char* const mist_source = R"(
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

MistFrame try_frame(Gpu& gpu, Frame& frame, const MistPasses& passes) {
    MistFrame seen;
    guard_call("record_mist");
    try {
        record_mist(frame, passes);
    } catch (const std::exception& e) { seen.error = *e.what() ? e.what() : "record_mist threw an exception"; }
    guard_call("");
    frame.end();
    if (!seen.error.empty()) return seen;
    for (const PassTime& pass : frame.times)
        if (&pass != &frame.times[0])
            seen.passes += (seen.passes.empty() ? "" : ", ") + pass.name + " (" + pass.stage + ")";
    const auto texels = gpu.read_back(frame.hdr);
    const auto at = [&](size_t x) {
        uint64_t texel = 0;
        std::memcpy(&texel, &texels[8 * (8 * 16 + x)], 8);
        return glm::vec3(glm::unpackHalf4x16(texel));
    };
    seen.left = at(3), seen.right = at(12);
    return seen;
}

}  // namespace

MistSeen try_record_mist(float red, float blue) {
    MistSeen seen;
    Gpu gpu(trial_device(seen.validation));
    const Pipeline sky =
        compute({.shader = "the sky of the check", .macros = {{"BLUE", std::to_string(blue)}}, .source = sky_source});
    const Pipeline mist = compute({.shader = "the mist of the check", .source = mist_source});
    const Pipeline quad = graphics({.vertex = "../tests/common/shaders/quad.vert",
                                    .fragment = "../tests/common/shaders/paint_one.frag",
                                    .cull = VK_CULL_MODE_NONE});
    Frame frame(gpu);
    frame.shows_discarded = true;
    const Paint paint{glm::vec4(red, 0, 0, 1), glm::vec4(red, 0, 0, 1)};
    for (const bool right : {false, true}) {
        frame.begin({16, 16}, 0.0f);
        frame.raster("before",
                     {.color = {clear(frame.hdr, glm::vec4(0, 0.5f, 0, 1))}, .depth = clear(frame.depth, 1.0f)},
                     [](Raster&) {});
        int draws = 0;
        const auto draw = [&](Raster& pass) {
            ++draws;
            pass.use(quad).set("quad", Quad{right ? glm::vec4(0, -1, 1, 1) : glm::vec4(-1, -1, 0, 1)});
            pass.set("paint", paint).draw(6);
        };
        seen.frames.push_back(try_frame(gpu, frame, {sky, mist, draw}));
        seen.frames.back().draws = draws;
        if (!seen.frames.back().error.empty()) break;
    }
    return seen;
}

}  // namespace lightwalk
