// Titles: letters stand upright, an outline is a pixel wide at least, and a shadow lies around it.
#include "../common/gpu_fixture.h"
#include "19_ambiance/titles.h"
#include "common/app/read_picture.h"

using namespace lightwalk;

namespace {

// Over a grey of 0.5, 128 pixels high.
ImageRgb titled(DeviceTest& test, const std::string& text, double size) {
    Titles titles;
    Timeline film;
    film.titles.push_back({.from_s = 0, .to_s = 10, .text = text, .size = size, .at = {0.25, 0.25}});
    test.frame.begin({256, 128}, 0);
    test.frame.raster("grey", {.color = {clear(test.frame.hdr, glm::vec4(0.5f))}}, [](Raster&) {});
    titles.record(test.frame, test.frame.hdr, film, 5);
    test.frame.end();
    return read_linear(test.gpu, test.frame.hdr);
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "a T has its bar above", "[19.letters]") {
    const ImageRgb seen = titled(*this, "T", 0.5);  // 64 pixels high, from row 32 to 96
    int upper = 0, lower = 0;
    for (int y = 32; y < 96; ++y)
        for (int x = 0; x < 256; ++x) (y < 64 ? upper : lower) += seen.at(x, y).g > 0.8f;
    CHECK(lower > 100);
    CHECK(upper > 1.5 * lower);
}

TEST_CASE_METHOD(DeviceTest, "letters of 8 pixels have an outline that is a pixel wide", "[19.letters]") {
    const ImageRgb seen = titled(*this, "THE LIGHT WALK", 8.0 / 128);
    float darkest = 1;
    for (const glm::vec3& pixel : seen.pixels) darkest = std::min(darkest, pixel.g);
    CHECK(darkest < 0.1f);  // 8% of 0.5 where the outline covers a pixel
}

TEST_CASE_METHOD(DeviceTest, "around its outline a letter has a shadow", "[19.letters]") {
    const ImageRgb seen = titled(*this, "I", 0.5);
    int last = 0;  // of the letter, in its middle row
    for (int x = 0; x < 256; ++x)
        if (seen.at(x, 64).g > 0.8f) last = x;
    REQUIRE(last > 0);
    // 7 pixels beyond its edge: 0.11 of its height, where 0.55 smoothstep(-15 / 72, 0, -0.11) of the light is taken.
    CHECK(double(seen.at(last + 7, 64).g) == Approx(0.5 * (1 - 0.55 * 0.45)).margin(0.03));
    CHECK(double(seen.at(last + 20, 64).g) == Approx(0.5).margin(0.002));
}

TEST_CASE("A and V stand nearer to each other than they are wide; two I do not", "[19.letters]") {
    Typeface face;
    face.read();
    const auto width = [&](const std::string& text) {
        float found = 0;
        face.line(text, found);
        return found;
    };
    CHECK(width("AV") < width("A") + width("V") - 0.03f);
    CHECK(width("II") == Approx(2 * width("I")));
}

TEST_CASE_METHOD(DeviceTest, "a part of a picture has that part of its title", "[19.letters]") {
    const auto drawn = [&](glm::uvec2 size, const Crop& crop) {
        Titles titles;
        Timeline film;
        film.titles.push_back({.from_s = 0, .to_s = 10, .text = "IV", .size = 0.5, .at = {0.25, 0.25}});
        frame.crop = crop;
        frame.begin(size, 0);
        frame.raster("grey", {.color = {clear(frame.hdr, glm::vec4(0.5f))}}, [](Raster&) {});
        titles.record(frame, frame.hdr, film, 5);
        frame.end();
        return read_linear(gpu, frame.hdr);
    };
    const ImageRgb whole = drawn({128, 128}, {}), part = drawn({64, 48}, {.whole = {128, 128}, .origin = {32, 64}});
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) REQUIRE(part.at(x, y) == whole.at(x + 32, y + 64));
}
