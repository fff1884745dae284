// What ./course check runs for 02.record_mist: two frames on a validated device, over what a frame before has left.
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "02_lambert_phong/exercises.h"
#include "common/check/check.h"
#include "common/check/guard.h"

using namespace lightwalk;

namespace {

// Everything is told apart by its colour: a blue sky, a red scene, mist that adds green by the depth it finds.
const char* const sky_source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), vec4(0.0, 0.0, 1.0, 1.0)); }
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
    glm::vec4 first{1, 0, 0, 1}, second{1, 0, 0, 1};
};

std::string color_text(glm::vec3 c) {
    return "(" + number_text(double(c.x)) + ", " + number_text(double(c.y)) + ", " + number_text(double(c.z)) + ")";
}

// What a wrong colour says.
std::string words_for(glm::vec3 got, bool scene) {
    if (got.x > 100 || !(got.x == got.x)) return "hdr holds what a pass has discarded: what is drawn over must be kept";
    if (got.y > 0.9f && !(scene && got.x > 0))
        return scene ? "the depth is that of the frame before, the nearest there is, and hides the scene: clear it to 0"
                     : "the depth is that of the frame before where nothing was drawn: clear it to 0";
    if (got.x > 0 && !scene) return "the scene of the frame before still shows";
    if (got.z == 0 && !scene) return "the sky is not there: no pass has drawn it, or the pass after it has cleared it";
    if (scene && got.y == 0) return "the mist is not there, or came before the scene";
    return "that is none of what the passes make";
}

}  // namespace

CHECK_EXERCISE(
    "02.record_mist",
    "ask of each image, pass by pass: is what it holds needed, then keep it; is it of the frame before, then "
    "clear it or write all of it") {
    std::string said;
    {
        Gpu gpu({.name = "",
                 .validate = true,
                 .surface_extensions = {},
                 .max_push_descriptors = {},
                 .on_message = [&](const char* message) {
                     if (said.empty()) said = message;
                 }});
        const Pipeline sky = compute({.shader = "the sky of the check", .source = sky_source});
        const Pipeline mist = compute({.shader = "the mist of the check", .source = mist_source});
        const Pipeline quad = graphics({.vertex = "../tests/common/shaders/quad.vert",
                                        .fragment = "../tests/common/shaders/paint_one.frag",
                                        .cull = VK_CULL_MODE_NONE});
        Frame frame(gpu);
        frame.shows_discarded = true;
        // The scene is the left half of the picture, then the right one.
        for (const bool right : {false, true}) {
            frame.begin({16, 16}, 0.0f);
            // What some frame before has left: green everywhere, and the nearest depth.
            frame.raster("before",
                         {.color = {clear(frame.hdr, glm::vec4(0, 0.5f, 0, 1))}, .depth = clear(frame.depth, 1.0f)},
                         [](Raster&) {});
            int draws = 0;
            const auto draw = [&](Raster& pass) {
                ++draws;
                pass.use(quad).set("quad", Quad{right ? glm::vec4(0, -1, 1, 1) : glm::vec4(-1, -1, 0, 1)});
                pass.set("paint", Paint{}).draw(6);
            };
            const std::string what = right ? "the second frame, in which the scene is on the right: "
                                           : "a frame in which the scene is on the left: ";
            guard_call("record_mist");
            try {
                record_mist(frame, {sky, mist, draw});
            } catch (const std::exception& e) {
                guard_call("");
                frame.end();
                check.expect(false, e.what(),
                             "what a pass binds stands in its reads or writes, or is one of its targets");
                return;
            }
            guard_call("");
            frame.end();
            std::string passes;
            for (const PassTime& pass : frame.times)
                if (&pass != &frame.times[0])
                    passes += (passes.empty() ? "" : ", ") + pass.name + " (" + pass.stage + ")";
            check.expect(passes == "sky (compute), shade (raster), mist (compute)",
                         what + "the passes are " + (passes.empty() ? "none" : passes) +
                             ", expected sky (compute), shade (raster), mist (compute)");
            check.expect(draws == 1, what + "the scene is drawn " + std::to_string(draws) + " times, expected once");
            const auto texels = gpu.read_back(frame.hdr);
            for (const int x : {3, 12}) {
                uint64_t texel = 0;
                std::memcpy(&texel, &texels[8 * (8 * 16 + size_t(x))], 8);
                const glm::vec3 got(glm::unpackHalf4x16(texel));
                const bool scene = right == (x == 12);
                const glm::vec3 wanted = scene ? glm::vec3(1, 0.5f, 0) : glm::vec3(0, 0, 1);
                check.expect(got == wanted,
                             what + "where " + (scene ? "the scene" : "the sky alone") + " is to be seen is " +
                                 color_text(got) + ", expected " + color_text(wanted) + " (red the scene, " +
                                 "blue the sky, green the depth that the mist found): " + words_for(got, scene));
            }
        }
    }
    check.expect(said.empty(), "validation says: " + said, "let the passes' statements make the barriers");
}
