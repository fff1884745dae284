// Descriptor sets of a pool.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "more draws than a pool has sets, with other buffers each, draw with their own") {
    const Pipeline sum = quad_pipeline({.cull = VK_CULL_MODE_NONE, .blend = Blend::add}, "sum.frag");
    const Image target = image({.format = four_floats, .size = {1, 1}});
    const Buffer a = gpu.upload("a", std::vector<float>(4, 3)), b = gpu.upload("b", std::vector<float>(4, 4));
    for (int repeat = 0; repeat < 3; ++repeat) {
        frame.begin({1, 1}, 0);
        frame.raster("sum", {.color = {clear(target, glm::vec4(0))}}, [&](Raster& pass) {
            pass.use(sum).set("quad", Quad{}).set("first", a);
            for (int i = 0; i < 600; ++i) pass.set("second", i % 2 ? b : a).draw(6);
        });
        frame.end();
        CHECK(read<float>(target).at(0) == 300 * (3 + 3) + 300 * (3 + 4));
    }
}

TEST_CASE("sets follow other buffers, other pipelines, and what has the handle of something destroyed") {
    Gpu gpu(validated());
    const Pipeline sum = quad_pipeline({}, "sum.frag"), paint = quad_pipeline({});
    const Image target(gpu.device, {.name = "target", .format = four_floats, .size = {1, 1}});
    Frame frame(gpu);
    const auto drawn = [&](float first, float second, bool paints) {
        const Buffer a = gpu.upload("a", std::vector<float>(4, first)),
                     b = gpu.upload("b", std::vector<float>(4, second));
        frame.begin({1, 1}, 0);
        frame.raster("sum", {.color = {target}}, [&](Raster& pass) {
            if (paints) pass.use(paint).set("quad", Quad{}).set("paint", Paint{}).draw(6);
            pass.use(sum).set("quad", Quad{}).set("first", a).set("second", b).draw(6);
        });
        frame.end();
        float texel = 0;
        std::memcpy(&texel, gpu.read_back(target).data(), 4);
        return texel;
    };
    for (int i = 0; i < 8; ++i) CHECK(drawn(float(i), 10, i % 3 == 1) == float(i) + 10);
    CHECK_NOTHROW(gpu.device.check_validation());
}
