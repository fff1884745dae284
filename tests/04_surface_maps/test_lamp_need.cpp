// The need rule for the shapes of lamps, with costs that no machine's load changes.
#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "catch.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/study/need.h"

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
    /// What is chosen, with times that are not this machine's: samples cost by their number.
    std::string choose(const char* file, double budget) {
        load_scene(*this, check_device(), file);
        LampShapes& lamps = objects.maps.lamps;
        lamps.method.set("point");
        const auto source = study_of(*this, lamps.method);
        const StudyPlan plan = read_study_of(lamps.method, parse_json(read_file(source), source.string()), all_knobs());
        const auto cost = [&](const Frame&) {
            return lamps.method.is("sampled") ? 10.0 * lamps.samples.value : 1.0 + double(lamps.method.index);
        };
        choose_candidates(*this, check_device(), plan,
                          {.budgets = {budget}, .picture = {{160, 90}, 0, 0, {}}, .clock = cost});
        return lamps.method.text();
    }
};

}  // namespace

TEST_CASE("the need rule takes points for small lamps, and for wide ones what is no point", "[04.lamp_need]") {
    Lit chapter;
    CHECK(study_of(chapter, chapter.objects.maps.lamps.method).filename() == "study_lamps.json");
    CHECK(chapter.choose("../tests/04_surface_maps/scenes/far_lamps.json", 0.01) == "point");
    CHECK(chapter.choose("scenes/low_lamp.json", 0.04) == "ltc");
    CHECK(chapter.choose("scenes/low_lamp.json", 0.005) == "sampled");
}
