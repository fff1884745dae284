// Picking by boxes on the device: a box without a thickness is met.
#include "../common/gpu_fixture.h"
#include "18_playground/item_box.h"
#include "18_playground/picking_error.h"
#include "common/view_rays.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "a flat box is picked from above", "[18.flat_box]") {
    const Pipeline pick = compute({.shader = "18_playground/boxes.comp"});
    const Image ids(gpu.device, {.name = "ids", .format = VK_FORMAT_R32_UINT, .size = {4, 4}});
    const Buffer boxes = gpu.upload("boxes", std::vector<ItemBox>{{{-1, 0, -1}, {1, 0, 1}}});
    const ViewRays down{.eye = {0, 1, 0}, .corner = {-0.5f, -1, -0.5f}, .right = {0.25f, 0, 0}, .down = {0, 0, 0.25f}};
    frame.begin({4, 4}, 0);
    frame.compute("pick", {.reads = {boxes}, .writes = {ids}}, [&](Compute& pass) {
        pass.use(pick).set("boxes", boxes).set("through", down);
        pass.set("count", uint32_t(1)).set("found_ids", ids).dispatch_threads(glm::uvec2(4));
    });
    frame.end();
    for (const uint32_t id : read<uint32_t>(ImageView(ids))) CHECK(id == 1);
}

TEST_CASE("a pick is wrong where another item has an eighth of the pixel more", "[18.wrong_picks]") {
    const auto wrong = [](size_t own, size_t other) {  // of 16 samples
        std::vector<uint32_t> fine(16, 0);
        std::fill_n(fine.begin(), own, 1u);
        std::fill_n(fine.begin() + long(own), other, 2u);
        return wrong_picks({1}, fine, {1, 1}, 4);
    };
    CHECK(wrong(9, 7) == 0);
    CHECK(wrong(7, 9) == 0);
    CHECK(wrong(6, 9) == 1);
    CHECK(wrong(0, 16) == 1);
    // Two pixels of 2 by 2 samples, side by side: the left one's item is the right one's.
    CHECK(wrong_picks({2, 2}, {1, 1, 2, 2, 1, 1, 2, 2}, {2, 1}, 2) == 0.5);
}
