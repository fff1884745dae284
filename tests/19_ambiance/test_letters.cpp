// Titles: letters stand upright, an outline is a pixel wide at least, and a shadow lies around it.
#include <cmath>
#include <map>

#include "../common/gpu_fixture.h"
#include "19_ambiance/titles.h"
#include "common/app/read_picture.h"

using namespace lightwalk;

namespace {

// Titles over a grey, 128 pixels high.
ImageRgb titled(DeviceTest& test, const std::vector<Title>& all, float grey) {
    Titles titles;
    Timeline film;
    film.titles = all;
    test.frame.begin({256, 128}, 0);
    test.frame.raster("grey", {.color = {clear(test.frame.hdr, glm::vec4(grey))}}, [](Raster&) {});
    titles.record(test.frame, test.frame.hdr, film, 5);
    test.frame.end();
    return read_linear(test.gpu, test.frame.hdr);
}

Title shown(const std::string& text, double size, glm::dvec2 at = {0.25, 0.25}) {
    return {.from_s = 0, .to_s = 10, .text = text, .size = size, .at = at};
}

ImageRgb titled(DeviceTest& test, const std::string& text, double size) {
    return titled(test, {shown(text, size)}, 0.5f);
}

// What an outline encloses, in heights of a capital: its area, the middle of that from the pen on, and the way to the next
// letter. From the font file, by fontTools 4.38 (StatisticsPen, hmtx).
struct LetterOutline {
    double area, middle_x, middle_y, advance;
};
const std::map<char, LetterOutline> outlines{{'H', {0.43316, 0.5119, 0.5001, 1.0229}},
                                             {'I', {0.18115, 0.1892, 0.5000, 0.3779}},
                                             {'L', {0.24803, 0.2730, 0.3857, 0.7783}},
                                             {'E', {0.39040, 0.3610, 0.4995, 0.8354}}};

}  // namespace

TEST_CASE_METHOD(DeviceTest, "a T has its bar above", "[19.letters]") {
    const ImageRgb seen = titled(*this, "T", 0.5);  // 64 pixels high, from row 32 to 96
    int upper = 0, lower = 0;
    for (int y = 32; y < 96; ++y)
        for (int x = 0; x < 256; ++x) (y < 64 ? upper : lower) += seen.at(x, y).g > 0.8f;
    CHECK(lower > 100);
    CHECK(upper > 1.5 * lower);
}

// On black, where neither outline nor shadow shows.
TEST_CASE_METHOD(DeviceTest, "each letter of two titles covers what its outline in the font encloses", "[19.letters]") {
    constexpr double height = 40;
    const std::vector<Title> two{shown("HIE", height / 128, {0.125, 0.5625}),
                                 shown("LIH", height / 128, {0.25, 0.0625})};
    const ImageRgb seen = titled(*this, two, 0);
    for (const Title& one : two) {
        double pen = one.at.x * 128;
        const double base = 128 * (1 - one.at.y);
        for (const char sign : one.text) {
            const LetterOutline& of = outlines.at(sign);
            const double end = pen + of.advance * height;
            double area = 0, x_sum = 0, y_sum = 0;
            for (int y = int(base - 1.2 * height); y < int(base + 0.2 * height); ++y)
                for (int x = int(pen); x < int(end); ++x) {
                    const double share = double(seen.at(x, y).g) / 0.94;  // of a pixel, in the letters' white
                    area += share;
                    x_sum += share * (x + 0.5 - pen);
                    y_sum += share * (base - y - 0.5);
                }
            INFO(one.text << ": " << sign);
            CHECK(area / (height * height) == Approx(of.area).epsilon(0.04));
            CHECK(x_sum / area / height == Approx(of.middle_x).margin(0.01));
            CHECK(y_sum / area / height == Approx(of.middle_y).margin(0.01));
            pen = end;
        }
    }
}

// On the letters' own white, where they do not show: beside an I the outline takes 0.92 of a pixel's light, and the shadow
// 0.55 smoothstep(0, 2.5 px, way from its end) of the 1.5 px beyond.
TEST_CASE_METHOD(DeviceTest, "an outline takes the light of a pixel on each side, not of a tenth more",
                 "[19.letters]") {
    const ImageRgb seen = titled(*this, {shown("I", 12.0 / 128, {0.5, 0.25})}, 0.94f);
    double taken = 0;
    for (int x = 0; x < 256; ++x)
        taken += 1 - double(seen.at(x, 90).g) / double(seen.at(0, 90).g);  // 0.94 in half floats
    const double shadow = 0.55 * 2.5 * (std::pow(0.6, 3) - std::pow(0.6, 4) / 2);
    CHECK(taken == Approx(2 * (0.92 + shadow)).margin(0.05));
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
    CHECK(width("I I") > width("II"));
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
