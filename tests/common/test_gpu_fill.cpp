// Cleared targets, by a load operation or by compute: the same contents, before and after they are drawn over.
#include "common/app/drawing.h"
#include "common/gpu/fill.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

constexpr VkFormat half_floats = VK_FORMAT_R16G16B16A16_SFLOAT, depth_format = VK_FORMAT_D32_SFLOAT;
constexpr glm::uvec2 large_size{300, 257};  // no multiple of a group

const Pipeline paint_over = quad_pipeline();
const Pipeline copy_depth = compute_pipeline("copy depth", R"(
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D depth;
layout(r32f) writeonly uniform image2D result;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(result)))) imageStore(result, at, texelFetch(depth, at, 0) + 1.0);
}
)");

struct AlwaysFills {
    explicit AlwaysFills(bool fills) { fills_targets_always() = fills; }
    ~AlwaysFills() { fills_targets_always().reset(); }
};

bool all_are(const std::vector<uint16_t>& texels, const std::vector<uint16_t>& one) {
    for (size_t i = 0; i < texels.size(); ++i)
        if (texels[i] != one[i % one.size()]) return false;
    return !texels.empty();
}

// 0.25, 0.5, -3 and 1 as half floats.
const glm::vec4 backdrop(0.25f, 0.5f, -3.0f, 1.0f);
const std::vector<uint16_t> backdrop_bits{0x3400, 0x3800, 0xc200, 0x3c00};

}  // namespace

TEST_CASE_METHOD(OnDevice, "a cleared target holds its value, one layer or several, filled or not", "[fill]") {
    for (const bool fills : {false, true}) {
        INFO(fills);
        const AlwaysFills always(fills);
        const Image colors = image({.format = half_floats, .size = large_size, .mips = 2, .layers = 3});
        const Image words = image({.format = VK_FORMAT_R32G32_UINT, .size = large_size});
        const Image depth = image({.format = depth_format, .size = large_size});
        frame.begin({4, 4}, 0);
        frame.raster("all", {.color = {clear(colors, glm::vec4(2.0f))}, .layers = 3}, [](Raster&) {});
        frame.raster("one", {.color = {clear(colors.mip(0).layer(1), backdrop)}}, [](Raster&) {});
        frame.raster("words", {.color = {clear(words, glm::vec4(1.0f))}, .depth = clear(depth, 0.25f)}, [](Raster&) {});
        frame.end();
        CHECK(all_are(read<uint16_t>(ImageView(colors).mip(0).layer(0)), {0x4000}));
        CHECK(all_are(read<uint16_t>(ImageView(colors).mip(0).layer(1)), backdrop_bits));
        CHECK(all_are(read<uint16_t>(ImageView(colors).mip(0).layer(2)), {0x4000}));
        CHECK(all_are(read<uint16_t>(words), {0x0000, 0x3f80}));
        CHECK(value(depth) == 0.25f);
    }
}

TEST_CASE_METHOD(OnDevice, "what is drawn lies over the value, and a target that is kept is not filled", "[fill]") {
    for (const bool fills : {false, true}) {
        INFO(fills);
        const AlwaysFills always(fills);
        const Image color = image({.format = half_floats, .size = large_size});
        frame.begin({4, 4}, 0);
        for (const bool kept : {false, true})
            frame.raster("draw", {.color = {kept ? keep(color) : clear(color, backdrop)}}, [&](Raster& pass) {
                const float left = kept ? 0.5f : -1.0f;
                pass.use(paint_over)
                    .set("quad", Quad{.rectangle = {left, -1, left + 0.5f, 1}})
                    .set("paint", Paint{})
                    .draw(6);
            });
        frame.end();
        const auto texels = read<uint16_t>(color);
        const std::vector<uint16_t> row(texels.begin(), texels.begin() + 4 * large_size.x);
        CHECK(row[0] == 0x3c00);
        CHECK(std::vector(row.begin() + 4 * 150, row.begin() + 4 * 151) == backdrop_bits);
        CHECK(row[4 * 240] == 0x3c00);
    }
}

TEST_CASE_METHOD(OnDevice, "small targets, several samples, slices and what is kept stay with their load operation",
                 "[fill]") {
    const auto filled = [&](const Image& of, uint32_t layers = 1) { return can_fill(gpu.device, clear(of), layers); };
    const Image color = image({.format = half_floats, .size = large_size});
    const Image several = image({.format = half_floats, .size = large_size, .samples = 4});
    CHECK(filled(color));
    CHECK_FALSE(filled(image({.format = half_floats, .size = {255, 255}})));
    CHECK(filled(image({.format = half_floats, .size = {255, 255}, .layers = 2}), 2));
    CHECK_FALSE(filled(several));
    CHECK_FALSE(filled(image({.format = VK_FORMAT_R8G8B8A8_SRGB, .size = large_size})));
    CHECK_FALSE(can_fill(gpu.device, keep(color), 1));
    CHECK_FALSE(can_fill(gpu.device, resolve(clear(several), color), 1));
    const Image volume = image({.format = half_floats, .size = large_size, .depth = 2});
    CHECK_FALSE(can_fill(gpu.device, clear(ImageView(volume).layer(1)), 1));
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a canvas that nobody draws into has its background, and depth for compute", "[fill]") {
    for (const bool fills : {false, true})
        for (const uint32_t samples : {1u, 4u}) {
            INFO(fills << ' ' << samples);
            const AlwaysFills always(fills);
            const Image color = image({.format = half_floats, .size = large_size});
            const Image depth = image({.format = depth_format, .size = large_size});
            const Image colors = image({.format = half_floats, .size = large_size, .samples = 4});
            const Image depths = image({.format = depth_format, .size = large_size, .samples = 4});
            const Image seen = image({.format = one_float, .size = large_size});
            Canvas canvas(color, depth, backdrop);
            if (samples > 1) canvas.multisampled(colors, depths);
            frame.begin({4, 4}, 0);
            const ImageView cleared = canvas.color(frame);
            if (samples == 1) {
                const ImageView read = canvas.depth(frame);
                frame.compute("seen", {.reads = {read}, .writes = {seen}}, [&](Compute& pass) {
                    pass.use(copy_depth).set("depth", read, nearest_clamp).set("result", seen);
                    pass.dispatch_threads(large_size);
                });
            }
            // A target that was cleared once is kept.
            frame.raster("nothing", {.color = {canvas.color_target()}, .depth = canvas.depth_target()}, [](Raster&) {});
            frame.end();
            CHECK(all_are(read<uint16_t>(cleared), backdrop_bits));
            if (samples == 1) CHECK(value(seen) == 1.0f);
        }
}

TEST_CASE_METHOD(OnDevice, "clears are measured without a word of validation; software is never asked", "[fill]") {
    CHECK_NOTHROW(clears_slowly(gpu));
    if (gpu.device.software()) CHECK_FALSE(fills_targets(gpu));
    frame.end();
}
