// The need rule for a module of any chapter: the responsible study, its usable part, and the messages.
#include "catch.h"
#include "common/base/error.h"
#include "common/check/check.h"
#include "common/study/need.h"
#include "common/study/study_plan.h"

using namespace lightwalk;

namespace {

// As chapter 03's module, with a picture of one grey: `tiled` is wrong, `every_light` is the reference.
struct Grey : Chapter {
    Choice method{*this, "method", {"one", "two"}, "one", "the chapter's own"};
    struct Lights : Module {
        using Module::Module;
        Choice method{*this, "method", {"every_light", "tiled", "clustered"}, "tiled", "how"};
        Choice falloff{*this, "falloff", {"inverse_square", "window"}, "window", "falloff"};
        Knob<float> threshold{*this, "threshold", 0.01f, {0, 1}, "of the module"};
    } lights{*this, "lamps", "lights"};
    struct Other : Module {
        using Module::Module;
        Knob<float> threshold{*this, "threshold", 0.5f, {0, 1}, "of another one"};
        Choice method{*this, "method", {"a", "b"}, "a", "no study's"};
    } other{*this, "other"}, shadow{*this, "shadow"};
    int trials = 0, frames = 0;

    Grey() { name = "99_grey"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    ImageView written(const Frame& frame) const override { return frame.linear(); }
    void frame(Frame& frame) override {
        ++frames;
        trials += tries_knobs;
        const float light = lights.method.is("tiled") ? 0.8f : 0.3f;
        frame.raster("fill", {.color = {clear(frame.hdr, glm::vec4(light))}}, [](Raster&) {});
        encode_srgb(frame);
    }
    std::string choose(KnobBase& knob, double budget) {
        return choose_method(*this, check_device(), knob, budget, {{64, 36}, 0, 0, {}});
    }
};

JsonWithLines study(const char* text) { return parse_json(text, "study.json"); }

}  // namespace

TEST_CASE("method choice: a module's study is the one that names its kind; a chapter's own is its own") {
    const Grey chapter;
    CHECK(study_of(chapter, chapter.lights.method).parent_path().filename() == "03_attenuation");
    CHECK(study_of(chapter, chapter.lights.falloff).empty());
    CHECK(study_of(chapter, chapter.other.method).empty());
    CHECK(study_of(chapter, chapter.method).empty());  // there is no chapter 99
}

TEST_CASE("method choice: knobs are the module's own first, and what the chapter does not have is left out") {
    Grey chapter;
    const JsonWithLines source =
        study(R"({"error_metric": "flip_mean", "truth": {"set": {"method": "every_light"}, "exact": true},
        "curves": [{"method": "tiled", "set": {"threshold": [0.25, 0.5]}, "where": {"falloff": "inverse_square"}},
                   {"method": "tiled", "set": {"cells": 3}}, {"method": "clustered", "set": {"other.threshold": 1}},
                   {"method": "by_magic"}]})");
    const StudyPlan plan = read_study_of(chapter.lights.method, source, chapter.all_knobs());
    CHECK(plan.truth == KnobValues{{"lamps.method", "every_light"}});
    REQUIRE(plan.candidates.size() == 3);
    CHECK(plan.candidates[1].all() == KnobValues{{"lamps.threshold", "0.5"}, {"lamps.method", "tiled"}});
    CHECK(plan.candidates[0].where == KnobValues{{"lamps.falloff", "inverse_square"}});
    CHECK(plan.candidates[2].all() == KnobValues{{"other.threshold", "1"}, {"lamps.method", "clustered"}});
    CHECK(chapter.lights.threshold == 0.01f);
    CHECK(chapter.lights.method.is("tiled"));
}

TEST_CASE("method choice: the fastest within the budget is set and said; while it is measured knobs are trials") {
    Grey chapter;
    const std::string line = chapter.choose(chapter.lights.method, 0.01);
    CHECK_FALSE(chapter.lights.method.is("tiled"));
    CHECK(chapter.method.is("one"));
    CHECK_THAT(line, Catch::Matchers::StartsWith("lamps.method: " + chapter.lights.method.text() +
                                                 " is the fastest within 0.01; 3 were measured"));
    CHECK_THAT(line, Catch::Matchers::EndsWith("at 64×36)"));
    CHECK((chapter.frames > 4 && chapter.trials == chapter.frames));
    CHECK_FALSE(chapter.tries_knobs);
}

TEST_CASE("method choice: the command line pins other knobs, not the method that is asked for") {
    Grey chapter;
    chapter.lights.method.pinned = true;
    chapter.choose(chapter.lights.method, 0.01);
    CHECK_FALSE(chapter.lights.method.is("tiled"));
    CHECK(chapter.lights.method.pinned);
}

TEST_CASE("method choice: it can be ended between two pictures, and all knobs are as they were") {
    Grey chapter;
    int pictures = 0;
    const auto end = [&] {
        if (++pictures == 3) throw InputError("enough");
    };
    CHECK_THROWS_WITH(choose_method(chapter, check_device(), chapter.lights.method, 0.01, {{64, 36}, 0, 0, {}}, end),
                      "enough");
    CHECK(chapter.frames == 2);
    CHECK(chapter.lights.method.is("tiled"));
    CHECK_FALSE(chapter.tries_knobs);
}

TEST_CASE("method choice: where nothing can be measured a line says why, and all knobs stay") {
    Grey chapter;
    const auto says = [&](KnobBase& knob, const char* why) {
        CHECK_THROWS_WITH(chapter.choose(knob, 0.01), Catch::Matchers::Contains(why));
        CHECK(chapter.frames == 0);
        CHECK(chapter.lights.method.is("tiled"));
    };
    says(chapter.other.method, "other.method: no study compares its methods");
    says(chapter.shadow.method,
         "shadow.method: its reference, {\"truth_samples\":32,\"visibility\":\"rays\"}, exists in chapter 05 only");
}
