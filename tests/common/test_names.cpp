// Misspelt names, and the panel's search in a knob's help.

#include "catch.h"
#include "common/app/chapter.h"
#include "common/base/names.h"
#include "common/window/knob_sections.h"
#include "common/window/knob_widgets.h"

using namespace lightwalk;

TEST_CASE("edit distance: letters to insert, delete, replace or swap") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("method", "metod") == 1);
    CHECK(edit_distance("method", "mehtod") == 1);
    CHECK(edit_distance("method", "mathod") == 1);
    CHECK(edit_distance("METHOD", "method") == 0);
    CHECK(edit_distance("ca", "abc") == 3);  // 2 with Damerau's own distance, which moves letters across others
    CHECK(edit_distance(std::string(5000, 'a'), "b") == 64);
}

TEST_CASE("the nearest names come first, with or without their module") {
    const std::vector<std::string> names{"maps.method", "shadow.method", "shadow.taps", "lamp", "show"};
    CHECK(nearest_names("shadow.metod", names) == std::vector<std::string>{"shadow.method", "maps.method"});
    CHECK(nearest_names("tabs", names, 1) == std::vector<std::string>{"shadow.taps"});
    CHECK(nearest_names("lmap", names, 1) == std::vector<std::string>{"lamp"});
    CHECK(nearest_names("colonade.json", {"avenue.json", "bunny.json", "colonnade.json"}, 1) ==
          std::vector<std::string>{"colonnade.json"});
    CHECK(nearest_names("x", {}).empty());
    CHECK(nearest_names("x", names, 100).size() == names.size());
}

TEST_CASE("an unknown name is told with the two nearest and how to list all") {
    CHECK(std::string(unknown_name("shot", "hrad", {"hard", "lamp", "soft"}, "--list shots lists all").what()) ==
          "unknown shot 'hrad'; the nearest are hard and lamp; --list shots lists all");
    CHECK(std::string(unknown_name("shot", "hrad", {"hard"}, "").what()) ==
          "unknown shot 'hrad'; the only one is hard");
    CHECK(std::string(unknown_name("shot", "hrad", {}, "").what()) == "unknown shot 'hrad'; there is none");
}

TEST_CASE("a choice's help says what each option is") {
    const std::string help =
        "Shadow filter: one comparison (hard), a fixed kernel, flat within (pcf), or one as wide as the penumbra "
        "(pcss)";
    CHECK(option_help(help, "hard") == "one comparison (hard)");
    CHECK(option_help(help, "pcf") == "flat within (pcf)");
    CHECK(option_help(help, "pcss") == "one as wide as the penumbra (pcss)");
    CHECK(option_help(help, "none").empty());
    CHECK(option_help("Loader: textbook (built on your exercises, slow), scan", "textbook") ==
          "textbook (built on your exercises, slow)");
    CHECK(option_help("Diffuse model: lambert, or wrapped", "lambert").empty());  // nothing but the name
    CHECK(option_help("View: the picture; light_count counts lights", "light").empty());
}

namespace {

struct Filtered : Chapter {
    Knob<float> bias_m{*this, "bias_m", 0.01f, {0.0f, 1.0f}, "Depth bias towards the light", "m"};
    Choice method{*this, "method", {"hard", "pcf"}, "hard", "Shadow filter: hard or pcf"};
    Knob<int> many{*this, "many", 3, {1, 16777216}, "Number of lights"};
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void frame(Frame&) override {}
};

}  // namespace

TEST_CASE("knobs of a module that differ in their units alone keep them in their labels", "[common.labels]") {
    struct Sun : Chapter {
        Knob<float> klx{*this, "sun_klx", 100.0f, {0.0f, 200.0f}, "Light of the sun", "klx"};
        Knob<float> deg{*this, "sun_deg", 0.5f, {0.0f, 10.0f}, "Angle of the sun", "degrees"};
        Knob<float> foam{*this, "foam", 1.0f, {0.0f, 1.0f}, "Share of foam"};
        Knob<float> foam_m{*this, "foam_m", 1.0f, {0.0f, 9.0f}, "Width of foam", "m"};
        Knob<float> wind{*this, "wind_m_s", 1.0f, {0.0f, 9.0f}, "Speed of the wind", "m/s"};
        Knob<float> walk{*this, "walk_m_per_s", 1.0f, {0.0f, 9.0f}, "Speed of the camera", "m/s"};
        std::string default_scene() const override { return ""; }
        Model load_model(const std::filesystem::path&) override { return {}; }
        void frame(Frame&) override {}
    } sun;
    CHECK(label_of(sun.klx) == "sun (klx)");
    CHECK(label_of(sun.deg) == "sun (degrees)");
    CHECK(label_of(sun.foam) == "foam");
    CHECK(label_of(sun.foam_m) == "foam (m)");
    CHECK(label_of(sun.wind) == "wind");
    CHECK(label_of(sun.walk) == "walk");
}

TEST_CASE("a text has all words of a search, case aside") {
    CHECK(has_words("bias_m", ""));
    CHECK(has_words("shadow.bias_m distance towards the Light", "light  BIAS "));
    CHECK(!has_words("shadow.bias_m distance towards the Light", "light filter"));
}

TEST_CASE("a knob's usage: what it takes and its default") {
    Filtered chapter;
    CHECK(chapter.bias_m.usage() == "0..1 m (0.01)");
    CHECK(chapter.method.usage() == "{hard,pcf} (hard)");
    CHECK(chapter.many.usage() == "1..16777216 (3)");
    CHECK(!chapter.method.changed());
    chapter.method.set("pcf");
    CHECK(chapter.method.changed());
    chapter.method.change_default("pcf");
    CHECK(!chapter.method.changed());
}

TEST_CASE("passes named after a module are its cost") {
    std::vector<PassTime> times(4);
    times[0].name = "shadow_map";
    times[0].gpu_ms = 1;
    times[1].name = "clear_shadow";
    times[1].gpu_ms = 2;
    times[2].name = "light_shadow_mask";
    times[2].gpu_ms = 4;
    times[3].name = "sh";
    times[3].gpu_ms = 8;
    CHECK(module_ms("shadow", times) == 3.0);
}
