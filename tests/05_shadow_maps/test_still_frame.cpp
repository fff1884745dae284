// Work of a frame in which nothing has changed since the one before.
#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_stage.h"
#include "catch.h"
#include "common/blocks_taken.h"
#include "common/gpu/gpu_work.h"

using namespace lightwalk;

namespace {

struct Stage : ModelChapter {
    LitStage world{*this};
    std::string default_scene() const override { return "scenes/colonnade_evening.json"; }
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);
        encode_srgb(frame);
    }
};

/// Draws the stage, and notes what a frame took.
struct StillStage {
    StillStage() { load_scene(chapter, gpu, chapter.default_scene()); }
    void draw() {
        const GpuWork before = gpu_work;
        const size_t blocks_before = blocks_taken;
        const uint64_t uploaded_before = gpu.uploaded_bytes;
        render(chapter, frame, {{64, 36}, 0, 0, {}});
        blocks = blocks_taken - blocks_before;
        uploaded = gpu.uploaded_bytes - uploaded_before;
        lists = gpu_work.lists - before.lists;
        searches = gpu_work.searches - before.searches;
        recorded = gpu_work.command_buffers - before.command_buffers;
    }
    std::vector<std::byte> picture() {
        draw();
        return gpu.read_back(frame.output);
    }
    Gpu gpu{DeviceOptions{}};
    Stage chapter;
    Frame frame{gpu};
    uint64_t blocks = 0, uploaded = 0, lists = 0, searches = 0, recorded = 0;
};

}  // namespace

TEST_CASE("where nothing moves no list is made or compared, and a frame takes few blocks of memory",
          "[05.still_frame]") {
    StillStage stage;
    const std::vector<std::byte> picture = stage.picture();
    const auto check_rest = [&] {
        for (int i = 0; i < 5; ++i) stage.draw();  // command buffers take turns
        CHECK(stage.uploaded == 0);
        CHECK(stage.lists == 0);
        CHECK(stage.searches == 0);
        CHECK(stage.recorded == 0);
        INFO(stage.blocks);
        CHECK(stage.blocks <= 45);
        CHECK(stage.picture() == picture);
    };
    check_rest();

    // A change shows at once, and so does its end.
    Shadow& shadow = stage.chapter.world.objects.shadow;
    shadow.method.set("none");
    CHECK(stage.picture() != picture);
    shadow.method.set("pcf");
    CHECK(stage.picture() == picture);
    const glm::vec3 before = stage.chapter.camera.position;
    stage.chapter.camera.position.x += 1;
    CHECK(stage.picture() != picture);
    stage.chapter.camera.position = before;
    check_rest();
}
