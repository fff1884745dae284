// Items that a frame at rest looks at, and emission that begins and ends.
#include "01_obj/model_chapter.h"
#include "06_deferred/many_lights.h"
#include "catch.h"
#include "common/gpu/gpu_work.h"

using namespace lightwalk;

namespace {

struct Night : ModelChapter {
    ManyLights world{*this};
    std::string default_scene() const override { return "scenes/night.json"; }
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        world.draw_light(frame, view, canvas);
        encode_srgb(frame);
    }
};

}  // namespace

TEST_CASE("a deferred frame at rest looks at no item, and emission shows from the frame in which a material gets it",
          "[06.still_frame]") {
    Gpu gpu{DeviceOptions{}};
    Night chapter;
    load_scene(chapter, gpu, chapter.default_scene());
    Frame frame(gpu);
    uint64_t lists = 0;
    const auto picture = [&] {
        const uint64_t before = gpu_work.lists;
        render(chapter, frame, {{64, 36}, 0, 0, {}});
        lists = gpu_work.lists - before;
        return gpu.read_back(frame.output);
    };
    const std::vector<std::byte> dark = picture();
    CHECK(picture() == dark);
    CHECK(lists == 0);

    const MaterialOverride was = chapter.scene.file.objects[0].material;  // the floor
    MaterialOverride glowing = was;
    glowing.emissive = glm::vec3(0.5f);
    const std::array<Scene::Paint, 1> glow{{{0, glowing}}}, rest{{{0, was}}};
    REQUIRE(chapter.scene.paint(glow));
    CHECK(picture() != dark);
    REQUIRE(chapter.scene.paint(rest));
    CHECK(picture() == dark);
    CHECK(picture() == dark);
    CHECK(lists == 0);
}
