// Parts of a chapter's frame: targets, histories, pictures shifted within a pixel, parts of a picture.
#include "catch.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/app/target.h"
#include "common/check/check.h"
#include "common/scene/view.h"

using namespace lightwalk;

namespace {

struct Blur : Module {
    using Module::Module;
    Target half{*this, {.name = "half", .scale = 0.5f}};
    Target fixed{*this, {.name = "fixed", .format = VK_FORMAT_R32_SFLOAT, .size = {8, 4}, .mips = 0}};
    Target chain{*this, {.name = "chain", .size = {8, 4}, .mips = 0}};
    History light{*this, {.name = "light"}};
};

// Fills the picture with a colour that tells how often it was drawn, and where its pixels lie.
struct Trial : Chapter {
    Blur blur{*this, "blur"};
    bool writes_history = true, writes_late = false, encodes_twice = false;
    std::vector<bool> valid;
    std::vector<glm::vec2> shifts;
    Trial() { name = "99_trial"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void frame(Frame& frame) override {
        valid.push_back(blur.light.valid());
        shifts.push_back(frame.crop.shift);
        const float grey = frame.samples.index == 0 ? 3.0f : 0.25f;
        frame.raster("fill", {.color = {clear(frame.hdr, glm::vec4(glm::vec3(grey), 1))}}, [](Raster&) {});
        frame.raster("level", {.color = {clear(blur.chain.mip(1), glm::vec4(0.5f))}}, [](Raster&) {});
        if (writes_history) frame.raster("keep", {.color = {blur.light.now()}}, [](Raster&) {});
        encode_srgb(frame);
        if (encodes_twice) encode_srgb(frame);
        if (writes_late) frame.raster("glow", {.color = {keep(frame.hdr)}}, [](Raster&) {});
    }
};

struct RenderTest {
    Gpu& gpu = check_device();
    Frame frame{gpu};
    Trial chapter;
    void draw(glm::uvec2 size = {16, 8}) { render(chapter, frame, {size, 0, 0, {}}); }
};

}  // namespace

TEST_CASE_METHOD(RenderTest, "targets: a share of the frame, or a size of their own; named by their module") {
    draw({17, 8});
    CHECK(chapter.blur.half.desc.size == glm::uvec2(9, 4));
    CHECK(chapter.blur.half.desc.name == "blur.half");
    CHECK(chapter.blur.fixed.desc.size == glm::uvec2(8, 4));
    CHECK(chapter.blur.fixed.desc.mips == 4);
    const VkImage fixed = chapter.blur.fixed.handle, half = chapter.blur.half.handle;
    draw({17, 8});
    CHECK(chapter.blur.half.handle == half);
    draw({32, 8});
    CHECK(chapter.blur.half.desc.size == glm::uvec2(16, 4));
    CHECK(chapter.blur.fixed.handle == fixed);
    chapter.blur.fixed.wanted.layers = 3;
    draw({32, 8});
    CHECK(chapter.blur.fixed.desc.layers == 3);
}

TEST_CASE_METHOD(RenderTest, "a level of an image can be looked at as a picture") {
    draw();
    const ImageRgb level = read_linear(gpu, chapter.blur.chain.mip(1));
    CHECK(level.width == 4);
    CHECK(level.height == 2);
    for (const glm::vec3& pixel : level.pixels) CHECK(pixel == glm::vec3(0.5f));
}

TEST_CASE_METHOD(RenderTest,
                 "history: valid where the frame before wrote it, at this size, and nothing was forgotten") {
    draw();
    draw();
    draw();
    CHECK(chapter.valid == std::vector<bool>{false, true, true});
    const VkImage before = chapter.blur.light.before().handle;
    draw();
    CHECK(chapter.blur.light.before().handle != before);  // they change places
    draw({8, 8});
    draw({8, 8});
    chapter.forget_history();
    draw({8, 8});
    draw({8, 8});
    CHECK(chapter.valid == std::vector<bool>{false, true, true, true, false, true, false, true});
    chapter.writes_history = false;
    draw({8, 8});
    draw({8, 8});
    CHECK(chapter.valid[8]);
    CHECK_FALSE(chapter.valid[9]);  // a frame did not write it
}

TEST_CASE_METHOD(RenderTest, "samples: the mean in linear light of pictures spread evenly over the pixel") {
    draw();
    CHECK(chapter.shifts == std::vector<glm::vec2>{{0, 0}});
    CHECK(frame.linear().desc.format == VK_FORMAT_R16G16B16A16_SFLOAT);
    chapter.samples.value = 4;
    chapter.shifts.clear();
    draw();
    // One picture of 3 and three of 1/4: codes would give the mean of 1 and three of 0.537, clamped.
    const float mean = (3.0f + 3 * 0.25f) / 4;
    CHECK(read_linear(gpu, frame.linear()).at(5, 5).g == Approx(mean));
    CHECK(int(read_picture(gpu, frame.output).at(5, 5)[0]) == int(std::lround(255.0 * double(linear_to_srgb(mean)))));
    CHECK(frame.times[0].name == "fill");
    CHECK(std::count_if(frame.times.begin(), frame.times.end(), [](const PassTime& t) { return t.name == "fill"; }) ==
          1);
    for (const int count : {4, 16, 64, 100}) {
        chapter.samples.value = count;
        chapter.shifts.clear();
        draw();
        glm::vec2 sum(0.0f);
        std::vector<int> columns(static_cast<size_t>(count)), rows(static_cast<size_t>(count));
        for (const glm::vec2& shift : chapter.shifts) {
            CHECK(glm::all(glm::lessThan(glm::abs(shift), glm::vec2(0.5f))));
            sum += shift;
            ++columns[static_cast<size_t>((shift.x + 0.5f) * float(count))];
            ++rows[static_cast<size_t>((shift.y + 0.5f) * float(count))];
        }
        CHECK(glm::length(sum) / float(count) < 0.51f / float(count) + 0.01f);
        for (const int in_column : columns) CHECK(in_column == 1);
        if ((count & (count - 1)) == 0)
            for (const int in_row : rows) CHECK(in_row == 1);
    }
}

TEST_CASE("a part of a picture: the same points at the same pixels") {
    const glm::uvec2 whole{960, 540}, size{64, 48};
    for (const glm::vec2 shift : {glm::vec2(0), glm::vec2(0.25f, -0.375f)}) {
        const Crop crop{.whole = whole, .origin = {320, 470}, .shift = shift};
        const glm::mat4 part = part_of(crop, size);
        for (const glm::vec2 pixel : {glm::vec2(320.5f, 470.5f), glm::vec2(350, 500), glm::vec2(383.5f, 517.5f)}) {
            const float w = 3.0f;
            const glm::vec4 clip(w * (2.0f * pixel / glm::vec2(whole) - 1.0f), 0.3f * w, w);
            const glm::vec4 in_part = part * clip;
            const glm::vec2 found = 0.5f * (glm::vec2(in_part) / in_part.w + 1.0f) * glm::vec2(size);
            CHECK(glm::distance(found, pixel - glm::vec2(crop.origin) - shift) < 2e-3f);
            CHECK(in_part.z == clip.z);
            CHECK(in_part.w == clip.w);
        }
    }
    CHECK(part_of({.whole = whole}, whole) == glm::mat4(1.0f));
}

TEST_CASE_METHOD(RenderTest, "what is drawn after the picture was encoded is refused", "[refused]") {
    CHECK_NOTHROW(draw());
    chapter.writes_late = true;
    CHECK_THROWS_WITH(draw(), "pass 'glow' writes hdr after the output, and is not seen: record it before");
    chapter.encodes_twice = true;
    CHECK_THROWS_WITH(draw(), "encode_srgb() writes over the output that this frame has: call it once");
}
