// Targets and the states of a graphics pipeline, each by a number it changes.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

const Pipeline paint = quad_pipeline();

}  // namespace

TEST_CASE_METHOD(OnDevice, "targets that do not fit are refused in words") {
    const Image small = image({.name = "small", .format = four_floats, .size = {2, 2}});
    const Image large = image({.name = "large", .format = four_floats, .size = {4, 4}});
    const Image several = image({.name = "several", .format = four_floats, .size = {4, 4}, .samples = 4});
    const auto refusal = [&](const RasterTargets& targets) {
        return failure_of([&] { frame.raster("x", targets, [](Raster&) {}); });
    };
    CHECK(refusal({.color = {large, small}}) ==
          "pass 'x': target small differs in size or samples from the pass's others");
    CHECK(refusal({.color = {large, several}}) ==
          "pass 'x': target several differs in size or samples from the pass's others");
    CHECK(refusal({.depth = large}) == "pass 'x': target large is no depth image");
    CHECK(refusal({.color = {read_only(large)}}) == "pass 'x': target large cannot be read-only: only depth can");
    CHECK(
        refusal({.color = {resolve(several, small)}}) ==
        "pass 'x': target several cannot be resolved into small: that takes several samples into one, of the same size "
        "and format");
    CHECK_THAT(refusal({.color = {large}, .layers = 2}), Catch::Matchers::EndsWith(": large has no layers 0 to 1"));
    frame.end();
    CHECK(failure_of([&] {
              image({.format = four_floats, .size = {4, 4}, .samples = 64});
          }) == "image test: the device has no 64 samples");
}

TEST_CASE_METHOD(OnDevice, "several samples are resolved to their mean") {
    const Image several = image({.name = "several", .format = four_floats, .size = {4, 4}, .samples = 4});
    const Image depths = image({.name = "depths", .format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}, .samples = 4});
    const Image mean = image({.name = "mean", .format = four_floats, .size = {4, 4}});
    const Image first = image({.name = "first", .format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}});
    const RasterTargets targets{.color = {resolve(clear(several, glm::vec4(0)), mean)},
                                .depth = resolve(clear(depths, 0.25f), first)};
    frame.raster("draw", targets, [&](Raster& pass) {
        // To the middle of the first column of pixels: half of its samples.
        pass.use(paint).set("quad", Quad{.rectangle = {-1, -1, -0.75f, 1}}).set("paint", Paint{}).draw(6);
    });
    frame.end();
    const auto texels = read<glm::vec4>(mean);
    CHECK(texels[0].r == 0.5f);
    CHECK(texels[1].r == 0.0f);
    CHECK(read<float>(first)[1] == 0.25f);
    CHECK(failure_of([&] { gpu.read_back(several); }) == "several has several samples: resolve it, then read back");
}

TEST_CASE_METHOD(OnDevice, "alpha to coverage covers as many samples as alpha says") {
    const Image several = image({.name = "several", .format = four_floats, .size = {4, 4}, .samples = 4});
    const Image mean = image({.name = "mean", .format = four_floats, .size = {4, 4}});
    const Pipeline covers = quad_pipeline({.alpha_to_coverage = true});
    frame.raster("draw", {.color = {resolve(clear(several, glm::vec4(0)), mean)}}, [&](Raster& pass) {
        pass.use(covers).set("quad", Quad{}).set("paint", Paint{.first = {1, 1, 1, 0.5f}}).draw(6);
    });
    frame.end();
    CHECK(read<glm::vec4>(mean)[5].r == 0.5f);
}

TEST_CASE_METHOD(OnDevice, "a pass without a target draws as many pixels as it says") {
    const Buffer count = [&] {
        Buffer made(gpu.device, {.name = "count", .bytes = 16});
        frame.transfer("zero", {.reads = {}, .writes = {made}},
                       [&](VkCommandBuffer commands) { vkCmdFillBuffer(commands, made.handle, 0, VK_WHOLE_SIZE, 0); });
        return made;
    }();
    const Pipeline counts = quad_pipeline({}, "count.frag");
    const auto draw = [&](Raster& pass) { pass.use(counts).set("quad", Quad{}).set("count", count).draw(6); };
    frame.raster("own size", {.reads = {count}, .writes = {count}, .size = {7, 3}}, draw);
    frame.raster("the frame's", {.reads = {count}, .writes = {count}}, draw);
    frame.end();
    CHECK(read<uint32_t>(count)[0] == 7 * 3 + 4 * 4);
}

TEST_CASE_METHOD(OnDevice, "every blend mode, for each target its own") {
    const Image a = image({.name = "a", .format = four_floats, .size = {4, 4}});
    const Image b = image({.name = "b", .format = four_floats, .size = {4, 4}});
    const glm::vec4 old{0.5f, 0.25f, 4, 0.5f}, fresh{2, 0.125f, 1, 0.25f};
    const auto blended = [&](Blend blend) {
        const Pipeline pipeline = quad_pipeline({.blend = {blend, Blend::opaque}}, "paint.frag");
        frame.begin({4, 4}, 0);
        frame.raster("blend", {.color = {clear(a, old), clear(b, old)}}, [&](Raster& pass) {
            pass.use(pipeline).set("quad", Quad{}).set("paint", Paint{fresh, glm::vec4(7)}).draw(6);
        });
        frame.end();
        CHECK(value(b) == 7.0f);
        return read<glm::vec4>(a)[0];
    };
    CHECK(blended(Blend::opaque) == fresh);
    CHECK(blended(Blend::alpha) == glm::vec4(0.875f, 0.21875f, 3.25f, 0.625f));
    CHECK(blended(Blend::premultiplied) == glm::vec4(2.375f, 0.3125f, 4, 0.625f));
    CHECK(blended(Blend::add) == glm::vec4(2.5f, 0.375f, 5, 0.75f));
    CHECK(blended(Blend::multiply) == glm::vec4(1, 0.03125f, 4, 0.125f));
    CHECK(blended(Blend::minimum) == glm::vec4(0.5f, 0.125f, 1, 0.25f));
    CHECK(blended(Blend::maximum) == glm::vec4(2, 0.25f, 4, 0.5f));
}

TEST_CASE_METHOD(OnDevice, "a pass without colour targets leaves later ones their blending", "[common.blending]") {
    const Image a = image({.name = "a", .format = four_floats, .size = {4, 4}});
    const Image b = image({.name = "b", .format = four_floats, .size = {4, 4}});
    const Image depth = image({.name = "depth", .format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}});
    const Pipeline depth_only = quad_pipeline({}, "depth_only.frag");
    const Pipeline blended = quad_pipeline({.blend = {Blend::multiply, Blend::minimum}}, "paint.frag");
    frame.raster("depth", {.depth = clear(depth, 0.25f)},
                 [&](Raster& pass) { pass.use(depth_only).set("quad", Quad{}).draw(6); });
    frame.raster("blend", {.color = {clear(a, glm::vec4(0.5f)), clear(b, glm::vec4(0.5f))}}, [&](Raster& pass) {
        pass.use(blended).set("quad", Quad{}).set("paint", Paint{glm::vec4(0.75f), glm::vec4(0.75f)}).draw(6);
    });
    frame.end();
    CHECK(value(depth) == 0.5f);
    CHECK(value(a) == 0.375f);
    CHECK(value(b) == 0.5f);
}

TEST_CASE_METHOD(OnDevice, "a target's components are written as its mask says") {
    const Image a = image({.name = "a", .format = four_floats, .size = {4, 4}});
    const Image b = image({.name = "b", .format = four_floats, .size = {4, 4}});
    const Pipeline masked = quad_pipeline(
        {.color_write = {write_nothing, write_rgb & ~VkColorComponentFlags(VK_COLOR_COMPONENT_G_BIT)}}, "paint.frag");
    frame.raster("mask", {.color = {clear(a, glm::vec4(1)), clear(b, glm::vec4(1))}}, [&](Raster& pass) {
        pass.use(masked).set("quad", Quad{}).set("paint", Paint{glm::vec4(5), glm::vec4(5)}).draw(6);
    });
    frame.end();
    CHECK(value(a) == 1.0f);
    CHECK(read<glm::vec4>(b)[0] == glm::vec4(5, 1, 5, 1));
}

TEST_CASE_METHOD(OnDevice, "depth is compared, written, clamped and moved as the pipeline says") {
    const Image depth = image({.name = "depth", .format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}});
    // The depth left by a rectangle over one of 0.5.
    const auto left_by = [&](const Pipeline::Graphics& states, const Quad& quad) {
        const Pipeline pipeline = quad_pipeline(states, "depth_only.frag");
        frame.begin({4, 4}, 0);
        frame.raster("depth", {.depth = clear(depth, 0.5f)},
                     [&](Raster& pass) { pass.use(pipeline).set("quad", quad).draw(6); });
        frame.end();
        return read<float>(depth)[5];
    };
    const auto flat = [](float z) { return Quad{.depth = z, .depth_right = z}; };
    CHECK(left_by({}, flat(0.75f)) == 0.75f);
    CHECK(left_by({}, flat(0.25f)) == 0.5f);
    CHECK(left_by({.depth_compare = Compare::less}, flat(0.25f)) == 0.25f);
    CHECK(left_by({.depth_compare = Compare::less}, flat(0.75f)) == 0.5f);
    CHECK(left_by({.depth_compare = Compare::equal}, flat(0.75f)) == 0.5f);
    CHECK(left_by({.depth_test = false}, flat(0.75f)) == 0.5f);
    CHECK(left_by({.depth_write = false}, flat(0.75f)) == 0.5f);
    CHECK(left_by({.depth_compare = Compare::always}, flat(0.25f)) == 0.25f);

    // A constant bias counts steps of the largest depth's exponent: 2^-24 for depths from 0.5 to 1.
    const float biased = left_by({.depth_bias = {.constant = 1024}}, flat(0.75f));
    CHECK(biased == Approx(0.75 + 1024 * std::exp2(-24.0)).epsilon(1e-7));
    CHECK(left_by({.depth_bias = {.constant = -1024}}, flat(0.75f)) < 0.75f);
    // The slope of 0.25 over 4 pixels, for each pixel.
    const Quad slanted{.depth = 0.6f, .depth_right = 0.85f};
    const float straight = left_by({}, slanted), moved = left_by({.depth_bias = {.slope = 2}}, slanted);
    CHECK(moved - straight == Approx(2 * 0.0625).epsilon(1e-3));
    const float clamped = left_by({.depth_bias = {.slope = 2, .clamp = 0.03125f}}, slanted);
    CHECK(clamped - straight == Approx(0.03125).epsilon(1e-3));
    CHECK(left_by({}, flat(1.5f)) == 0.5f);  // cut off at the near plane
    CHECK(left_by({.depth_clamp = true}, flat(1.5f)) == 1.0f);
}
