// Picking by boxes on the device, outlines and lines.
#include "../common/gpu_fixture.h"
#include "01_obj/camera_view.h"
#include "18_playground/item_box.h"
#include "18_playground/mark_data.h"
#include "18_playground/playground.h"
#include "common/app/read_picture.h"
#include "common/view_rays.h"

using namespace lightwalk;

namespace {

// Boxes above a square of 4 by 4 pixels are looked at from a metre above: what every pixel picks.
std::vector<uint32_t> picked_from_above(DeviceTest& test, const std::vector<ItemBox>& items) {
    const Pipeline pick = compute({.shader = "18_playground/boxes.comp"});
    const Image ids(test.gpu.device, {.name = "ids", .format = VK_FORMAT_R32_UINT, .size = {4, 4}});
    const Buffer boxes = test.gpu.upload("boxes", items);
    const ViewRays down{.eye = {0, 1, 0}, .corner = {-0.5f, -1, -0.5f}, .right = {0.25f, 0, 0}, .down = {0, 0, 0.25f}};
    test.frame.begin({4, 4}, 0);
    test.frame.compute("pick", {.reads = {boxes}, .writes = {ids}}, [&](Compute& pass) {
        pass.use(pick).set("boxes", boxes).set("through", down);
        pass.set("count", uint32_t(items.size())).set("found_ids", ids).dispatch_threads(glm::uvec2(4));
    });
    test.frame.end();
    return test.read<uint32_t>(ImageView(ids));
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "a flat box is picked from above; of two the nearer one, in either order",
                 "[18.flat_box]") {
    const std::vector<uint32_t> first(16, 1), second(16, 2);
    const ItemBox near{{-1, 0, -1}, {1, 0.5f, 1}}, far{{-1, -2, -1}, {1, -1, 1}};
    CHECK(picked_from_above(*this, {{{-1, 0, -1}, {1, 0, 1}}}) == first);
    CHECK(picked_from_above(*this, {near, far}) == first);
    CHECK(picked_from_above(*this, {far, near}) == second);
}

namespace {

// How much outline of a width of 2 a row of pixels has. `ids`: an item's number in each, 0 for none; `selected`: of each item.
void check_outline(DeviceTest& test, const std::vector<uint32_t>& ids_of_pixels, const std::vector<uint32_t>& of_items,
                   const std::vector<float>& wanted) {
    const auto count = static_cast<uint32_t>(wanted.size());
    const Pipeline outline = compute({.shader = "18_playground/outline.comp"});
    const Image ids(test.gpu.device, {.name = "ids", .format = VK_FORMAT_R32_UINT, .size = {count, 1}, .kept = true});
    const Buffer selected = test.gpu.upload("selected", of_items);
    Frame& frame = test.frame;
    frame.begin({count, 1}, 0);
    frame.upload("ids", ids, std::as_bytes(std::span(ids_of_pixels)));
    frame.raster("black", {.color = {clear(frame.hdr, glm::vec4(0, 0, 0, 1))}}, [](Raster&) {});
    frame.compute("outline", {.reads = {ids, selected, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(outline).set("ids", ids, nearest_clamp).set("selected", selected).set("width", 2.0f);
        pass.set("picture", frame.hdr).dispatch_threads(glm::uvec2(count, 1));
    });
    frame.end();
    const ImageRgb seen = read_linear(test.gpu, frame.hdr);
    for (uint32_t x = 0; x < count; ++x) CHECK(seen.at(int(x), 0).r == Approx(wanted[x]).margin(1e-3));
}

}  // namespace

// A pixel's share of a disc around the selected one: all of the first, half of that two pixels away, for a width of 2.
TEST_CASE_METHOD(DeviceTest, "an outline reaches as far as its width, and half of a pixel is half as bright") {
    check_outline(*this, {0, 0, 0, 0, 1, 0, 0, 0, 0}, {1}, {0, 0, 0.5f, 1, 0, 1, 0.5f, 0, 0});
}

// Item 2 is a part of the first entry, item 4 is not selected.
TEST_CASE_METHOD(DeviceTest, "each selected entry has an outline of its own, and its parts have none",
                 "[18.outlines]") {
    check_outline(*this, {0, 1, 1, 2, 2, 3, 3, 3, 4}, {1, 1, 2, 0}, {1, 0, 0, 0.5f, 1, 0, 0, 0, 1});
}

namespace {

// A line from the middle of a picture of 32 by 32 pixels, a metre away, to a point, seen from the eye; or the same turned round.
ImageRgb lined(DeviceTest& test, glm::vec3 to, bool turned) {
    const Pipeline lines = graphics({.vertex = "18_playground/line.vert",
                                     .fragment = "18_playground/line.frag",
                                     .cull = VK_CULL_MODE_NONE,
                                     .depth_test = false,
                                     .depth_write = false});
    Camera camera{.fov_y_rad = glm::half_pi<float>()};
    camera.position = {5, 3, 2};
    camera.target = camera.position - glm::vec3(0, 0, 1);
    const View view = view_of(camera, {32, 32});
    MarkSegment line{camera.target, 4, camera.position + to, 1, {1, 1, 1}};
    if (turned) std::swap(line.from, line.to);
    const Buffer buffer = test.gpu.upload("lines", std::vector<MarkSegment>{line});
    Frame& frame = test.frame;
    frame.begin({32, 32}, 0);
    const ViewScope scope(frame, view);
    frame.raster("line", {.color = {clear(frame.hdr, glm::vec4(0, 0, 0, 1))}, .reads = {buffer}},
                 [&](Raster& pass) { pass.use(lines).set("lines", buffer).draw(6); });
    frame.end();
    return read_linear(test.gpu, frame.hdr);
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "a line that ends behind the camera goes on to the picture's edge") {
    for (const bool turned : {false, true}) {
        const ImageRgb seen = lined(*this, {0.7f, 0, 2}, turned);
        for (int x = 0; x < 32; ++x) CHECK(seen.at(x, 16).g == (x < 16 ? 0.0f : 1.0f));
    }
}

// At 2 m the picture is 4 m wide: 8 pixels a metre from its middle.
TEST_CASE_METHOD(DeviceTest, "a line ends where its end is seen, at either end", "[18.line_end]") {
    for (const bool turned : {false, true}) {
        const ImageRgb seen = lined(*this, {1, 0, -2}, turned);
        for (int x = 0; x < 32; ++x) CHECK(seen.at(x, 16).g == (x < 16 || x >= 24 ? 0.0f : 1.0f));
    }
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
