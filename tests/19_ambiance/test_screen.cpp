// Passes over the whole picture: cross-fades and strips.
#include <glm/gtc/packing.hpp>

#include "../common/gpu_fixture.h"
#include "common/app/read_picture.h"

using namespace lightwalk;

namespace {

Image grey(DeviceTest& test, const char* name, glm::uvec2 size, float light) {
    Image image(test.gpu.device, {.name = name, .format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = size});
    test.frame.raster(name, {.color = {clear(image, glm::vec4(glm::vec3(light), 1))}}, [](Raster&) {});
    return image;
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "a cross-fade has the later scene's share of the later scene's light") {
    const Pipeline mix = compute({.shader = "19_ambiance/mix.comp"});
    frame.begin({8, 8}, 0);
    const Image before = grey(*this, "before", {8, 8}, 1), later = grey(*this, "later", {8, 8}, 3);
    frame.compute("mix", {.reads = {before, later}, .writes = {later}}, [&](Compute& pass) {
        pass.use(mix)
            .set("before", before, nearest_clamp)
            .set("picture", later)
            .set("share", 0.25f)
            .dispatch_threads(glm::uvec2(8));
    });
    frame.end();
    for (const glm::vec3& pixel : read_linear(gpu, later).pixels) CHECK(pixel.g == Approx(1.5));
}

TEST_CASE_METHOD(DeviceTest, "strips fill a picture whose width is no multiple of four, each from its own edge") {
    const Pipeline strips = compute({.shader = "19_ambiance/strips.comp"});
    // 4 * strip + column / 8: a strip is 3 or 4 pixels wide, and begins at 3.75 of them, rounded down.
    constexpr int wide = 15;
    frame.begin({wide, 2}, 0);
    std::vector<Image> sources;
    for (int strip = 0; strip < 4; ++strip) {
        sources.emplace_back(gpu.device, Image::Desc{.name = "strip", .size = {4, 2}, .kept = true});
        std::vector<uint64_t> texels;
        for (int i = 0; i < 8; ++i)
            texels.push_back(glm::packHalf4x16(glm::vec4(4 * float(strip) + 0.125f * float(i % 4))));
        frame.upload("strip", sources.back(), std::as_bytes(std::span(texels)));
    }
    frame.compute(
        "strips", {.reads = {sources[0], sources[1], sources[2], sources[3]}, .writes = {frame.hdr}},
        [&](Compute& pass) {
            pass.use(strips).set("strip_0", sources[0], nearest_clamp).set("strip_1", sources[1], nearest_clamp);
            pass.set("strip_2", sources[2], nearest_clamp)
                .set("strip_3", sources[3], nearest_clamp)
                .set("result", frame.hdr);
            pass.dispatch_threads(glm::uvec2(wide, 2));
        });
    frame.end();
    const ImageRgb seen = read_linear(gpu, frame.hdr);
    for (int x = 0; x < wide; ++x) {
        int strip = 3;
        while (x < wide * strip / 4) --strip;
        const int within = x - wide * strip / 4;
        const float wanted = strip > 0 && within == 0 ? 0.7f : 4 * float(strip) + 0.125f * float(within);
        CHECK(seen.at(x, 0).g == Approx(wanted).margin(2e-3));
    }
}
