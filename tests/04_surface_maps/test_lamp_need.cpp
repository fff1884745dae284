// The need rule for the shapes of lamps: by errors alone, since times are the machine's.
#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "catch.h"
#include "common/check/check.h"
#include "common/study/method_choice.h"

using namespace lightwalk;

namespace {

struct Lit : ModelChapter {
    SurfaceScene objects{*this, "objects"};

    Lit() { name = "99_lit"; }
    std::string default_scene() const override { return ""; }
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {objects});
        encode_srgb(frame);
    }
    /// The chosen method, at most so wrong.
    std::string choose(const char* file, double budget) {
        load_scene(*this, check_device(), file);
        objects.maps.lamps.method.set("point");
        const std::string says =
            choose_method(*this, check_device(), objects.maps.lamps.method, budget, {{160, 90}, 0, 0, {}});
        INFO(says);
        CHECK(says.find("is the fastest") != std::string::npos);
        return objects.maps.lamps.method.text();
    }
};

}  // namespace

TEST_CASE("the need rule takes points for small lamps, and for wide ones what is no point", "[04.lamp_need]") {
    Lit chapter;
    CHECK(study_of(chapter, chapter.objects.maps.lamps.method).filename() == "study_lamps.json");
    CHECK(chapter.choose("../tests/04_surface_maps/scenes/far_lamps.json", 0.03) != "sampled");
    const std::string wide = chapter.choose("scenes/low_lamp.json", 0.02);
    CHECK(wide != "point");
    CHECK(wide != "representative");
}
