// Studies: settings of a scene's entry, measurements, intermediate results, and what is refused.
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/app/shots.h"
#include "common/app/target.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/scene/json_lines.h"
#include "common/study/study.h"
#include "common/study/study_plan.h"
#include "file_fixture.h"

using namespace lightwalk;
using nlohmann::json;

namespace {

/// A picture of one grey: `light`, too bright by 1 / (8 looks) where the method is coarse.
struct GreyStudy : Chapter {
    Choice method{*this, "method", {"exact", "coarse"}, "exact", "how"};
    Knob<float> light{*this, "light", 0.25f, {0.0f, 4.0f}, "how bright"};
    Knob<int> looks{*this, "looks", 1, {1, 1024}, "how many"};
    std::vector<std::pair<std::string, float>> prepared;  // scene and light, in order
    std::string fails_at;                                 // a scene
    bool measures = false, rude = false;
    bool codes = false;    // the encoded picture is judged
    bool gathers = false;  // adds the previous value
    bool tables = false;   // a pass makes a table in the first frame with a knob's value
    std::string table_of;  // the knobs that it was made with
    float a_seed = 0;      // added for each seed
    History past{*this, {.name = "past", .size = {1, 1}}};

    GreyStudy() { name = "99_grey"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void prepare(Gpu&, Scene&) override {
        const std::string file = scene.file.file.stem().string();
        if (file == fails_at) throw Failure("interrupted");
        prepared.emplace_back(file, light.value);
    }
    void frame(Frame& frame) override {
        if (const std::string now = method.text() + " " + looks.text(); tables && std::exchange(table_of, now) != now)
            frame.raster("table", {.color = {clear(frame.hdr, glm::vec4(0))}}, [](Raster&) {});
        const float before = gathers && past.valid() ? 0.125f : 0.0f;
        frame.raster("past", {.color = {past.now()}}, [](Raster&) {});
        const float grey = before + light + a_seed * float(frame.seed) +
                           (method.is("coarse") ? 0.125f / static_cast<float>(looks.value) : 0.0f);
        frame.raster("fill", {.color = {clear(frame.hdr, glm::vec4(glm::vec3(grey), 1))}}, [](Raster&) {});
        encode_srgb(frame);
    }
    ImageView judged(const Frame& frame) const override { return codes ? frame.output : frame.linear(); }
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (!measures) return;
        if (rude) error["rmse"] = 1;
        Frame further(gpu);
        looks.value = 512;
        render(*this, further, {size, 0, 0, {}});
        error["missing"] = double(light) - double(read_linear(gpu, further.hdr).at(0, 0).x);
        error["width"] = size.x;
    }
};

struct StudyFolder : FileFolder {
    StudyFolder() {
        for (const char* scene : {"a", "b"})
            write_file(path / (std::string(scene) + ".json"), R"({"knobs": {"light": 0.5}})");
    }
    std::string scene(const char* name) const { return (path / name).string() + ".json"; }
};

struct StudyTest {
    StudyFolder folder;
    GreyStudy chapter;
    Options options;
    nlohmann::json study = {
        {"title", "Greys"},
        {"error_metric", "max"},
        {"stage", "fragment"},
        {"size", {16, 8}},
        {"rounds", 1},
        {"truth", {{"set", {{"method", "exact"}}}, {"exact", true}}},
        {"scenes", {folder.scene("a"), {{"scene", folder.scene("b")}, {"set", {{"light", 1}}}, {"label", "bright"}}}},
        {"curves", {{{"method", "exact"}}, {{"method", "coarse"}, {"set", {{"looks", {1, 2}}}}}}}};

    StudyTest() { options.study = (folder.path / "out.json").string(); }
    nlohmann::json measure() {
        nlohmann::json result = resume();
        std::filesystem::remove(options.study + ".partial");
        return result;
    }
    nlohmann::json resume() { return measure_study(study.dump(1), "study.json", options, chapter, check_device()); }
    /// Its error message; empty if it is usable.
    std::string refusal() {
        return refusal_of([&] { read_study(parse_json(study.dump(1), "study.json"), chapter.all_knobs()); });
    }
};

}  // namespace

TEST_CASE_METHOD(StudyTest, "study: what a scene sets holds for its points, its truth and while the chapter prepares") {
    const json result = measure();
    CHECK(chapter.prepared == std::vector<std::pair<std::string, float>>{{"a", 0.5f}, {"b", 1.0f}});
    REQUIRE(result["points"].size() == 6);
    const auto point = [&](size_t i) { return result["points"][i]; };
    CHECK(point(1)["scene"] == "a");
    CHECK(point(1)["knobs"] == json{{"looks", 1}});
    CHECK(point(4)["scene"] == "bright");
    CHECK(point(4)["knobs"] == json{{"light", 1}, {"looks", 1}});
    for (const size_t i : {0u, 3u}) CHECK(point(i)["error"]["max"] == 0);  // the truth is this scene's
    for (const size_t i : {1u, 4u}) CHECK(point(i)["error"]["max"] == 0.125);
    for (const size_t i : {2u, 5u}) CHECK(point(i)["error"]["max"] == 0.0625);
    CHECK(result["scenes"]["bright"]["set"] == json{{"light", 1}});
    CHECK(result["scenes"]["bright"]["file"] == folder.scene("b"));
    // One 8-bit step of a brighter scene is a larger one.
    const double dark = result["scenes"]["a"]["one_step"]["max"],
                 bright = result["scenes"]["bright"]["one_step"]["max"];
    CHECK(dark == Approx(0.0062).margin(0.0005));
    CHECK(bright == Approx(0.0089).margin(0.0005));
    CHECK(result["truth"] == json{{"method", "exact"}, {"knobs", json::object()}, {"exact", true}});
    for (const json& measured : result["points"]) {  // in one round the median is the time
        double sum = 0;
        REQUIRE(measured["time_ms"]["per_pass"].size() == 3);
        for (const json& pass : measured["time_ms"]["per_pass"]) sum += pass.get<double>();
        CHECK(measured["time_ms"]["median"].get<double>() == Approx(sum));
    }
}

TEST_CASE_METHOD(StudyTest, "study: a table counts, or is left out of what each frame costs") {
    chapter.tables = true;
    for (const bool each_frame : {false, true}) {
        if (each_frame) study["times"] = "each_frame";
        const json result = measure();
        REQUIRE(result["points"].size() == 6);
        for (const json& point : result["points"]) CHECK(point["time_ms"]["per_pass"].contains("table") != each_frame);
    }
    study["times"] = "tables";
    CHECK_THAT(refusal(), Catch::Matchers::Contains("\"each_frame\""));
}

TEST_CASE_METHOD(StudyTest, "study: a scene of another chapter may name modules that this one lacks",
                 "[common.foreign]") {
    write_file(folder.scene("a"), R"({"knobs_of": "98_other", "knobs": {"air.haze": 3, "light": 0.5}})");
    const json result = measure();
    CHECK(chapter.prepared[0] == std::pair<std::string, float>("a", 0.5f));
    CHECK(result["points"].size() == 6);
    CHECK(result["points"][1]["error"]["max"] == 0.125);
}

TEST_CASE_METHOD(StudyTest, "study: a truth with samples is doubled in each scene") {
    study["truth"] = {{"set", {{"method", "coarse"}, {"looks", 16}}},
                      {"doubled", {{"method", "coarse"}, {"looks", 32}}},
                      {"most_change", 0.004}};
    const json result = measure();
    CHECK(result["scenes"]["a"]["doubling"]["max"] == Approx(1.0 / 256));
    CHECK(result["truth"]["doubling_change"] == Approx(1.0 / 256));
    CHECK_FALSE(result["truth"].contains("exact"));
    study["truth"]["most_change"] = 0.0039;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("a: doubling the truth's samples changes it by 0.0039"));
}

TEST_CASE_METHOD(StudyTest, "study: a truth of pictures is their mean, and half of them say how far it moves") {
    chapter.a_seed = 0.125f;
    study["truth"] = {{"set", {{"method", "exact"}}}, {"pictures", 4}, {"most_change", 0.125}};
    const json result = measure();
    CHECK(result["points"][0]["error"]["max"] == 0.1875);  // the mean of seeds 0 to 3 against 0
    CHECK(result["scenes"]["a"]["doubling"]["max"] == 0.125);
    CHECK(result["truth"]["doubling_change"] == 0.125);
    CHECK(result["truth"]["pictures"] == 4);
    study["truth"]["most_change"] = 0.124;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("a: doubling the truth's samples changes it by 0.125"));
}

TEST_CASE_METHOD(StudyTest, "study: errors of the chapter's own, with the point's knobs, which it finds put back") {
    chapter.measures = true;
    study["error_metric"] = "missing";
    study["metrics"] = {{"missing", "missing light"}};
    const json result = measure();
    CHECK(result["metrics"] == study["metrics"]);
    for (size_t i = 0; i < 6; ++i) {
        const double expected = i % 3 == 0 ? 0 : -0.125 / 512;
        CHECK(result["points"][i]["error"]["missing"] == Approx(expected).margin(0.0003));
        CHECK(result["points"][i]["error"]["width"] == 16);
    }
    CHECK(result["points"][4]["error"]["max"] == 0.125);  // measured before
    const KnobList knobs = chapter.all_knobs();
    chapter.looks.value = 7;
    {
        const KeptKnobs kept(knobs);
        chapter.looks.value = 9;
        chapter.method.set("coarse");
    }
    CHECK(chapter.looks == 7);

    chapter.rude = true;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("measures 'rmse' as 1"));
    chapter.measures = false;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains(
                                     "error_metric is 'missing', but no point of a has it; points have: flip_mean, "));
}

TEST_CASE_METHOD(StudyTest, "study: the encoded picture can be what is judged: its steps show, and white is the most") {
    chapter.codes = true;
    study["scenes"][1]["set"]["light"] = 1.5;
    const json result = measure();
    const double linear = srgb_to_linear(std::round(255.0f * linear_to_srgb(0.625f)) / 255.0f) -
                          srgb_to_linear(std::round(255.0f * linear_to_srgb(0.5f)) / 255.0f);
    CHECK(result["points"][1]["error"]["max"] == Approx(linear).epsilon(1e-4));
    CHECK(result["points"][1]["error"]["max"] != 0.125);
    CHECK(result["points"][4]["error"]["max"] == 0);
}

TEST_CASE_METHOD(StudyTest, "study: every point and the truth start without a history") {
    chapter.gathers = true;
    study["truth"] = {{"set", {{"method", "exact"}}}, {"doubled", {{"method", "exact"}}}, {"most_change", 0}};
    const json result = measure();
    for (const size_t i : {0u, 3u}) CHECK(result["points"][i]["error"]["max"] == 0);
    for (const size_t i : {1u, 4u}) CHECK(result["points"][i]["error"]["max"] == 0.125);
}

TEST_CASE_METHOD(StudyTest, "study: what the need rule chooses for each budget, and points for some scenes alone") {
    study["size"] = {32, 16};
    study["curves"] = {{{"method", "exact"}},
                       {{"method", "coarse"}, {"set", {{"looks", {1, 512}}}}},
                       {{"method", "coarse"}, {"set", {{"looks", 4}}}, {"where", {{"light", 1}}}}};
    study["budgets"] = {0, 1};
    const json result = measure();
    CHECK(result["points"].size() == 7);
    const json choices = result["scenes"]["bright"]["choices"];
    REQUIRE(choices.size() == 2);
    CHECK(choices[0]["budget"] == 0);
    CHECK(choices[0]["choice"]["error"] == 0);
    CHECK(choices[0]["candidates"].size() == 4);
    CHECK(result["scenes"]["a"]["choices"][0]["candidates"].size() == 3);
    for (const json& c : choices[1]["candidates"]) CHECK(c["enough"] == true);
    study["candidates"] = {{{"method", "coarse"}}};
    CHECK(measure()["scenes"]["a"]["choices"][0]["none_would_do"]);
}

TEST_CASE_METHOD(StudyTest, "study: the size given stands for the study's, and the result says both") {
    json result = measure();
    CHECK(result["size"] == json{16, 8});
    CHECK(result["command"] == "./course study 99");
    chapter.measures = options.size_given = true;
    options.size = {24, 12};
    options.device = "some";
    result = measure();
    CHECK(result["size"] == json{24, 12});
    CHECK(result["points"][0]["error"]["width"] == 24);
    CHECK(result["command"] == "./course study 99 --device some --size 24x12");
}

TEST_CASE_METHOD(StudyTest,
                 "study: interrupted, it goes on after the scenes that are done; another study starts anew") {
    const auto scenes = [&] {
        std::string names;
        for (const auto& [scene, light] : chapter.prepared) names += scene;
        chapter.prepared.clear();
        return names;
    };
    chapter.fails_at = "b";
    CHECK_THROWS_WITH(resume(), "interrupted");
    CHECK(scenes() == "a");
    chapter.fails_at = "";
    const json whole = resume();
    CHECK(scenes() == "b");
    CHECK(whole["points"].size() == 6);
    CHECK(whole["points"][0]["scene"] == "a");
    CHECK(whole["points"][3]["scene"] == "bright");
    resume();
    CHECK(scenes().empty());
    study["scenes"][1]["set"]["light"] = 2;
    resume();
    CHECK(scenes() == "ab");
    options.size_given = true;
    resume();
    CHECK(scenes() == "ab");
}

TEST_CASE_METHOD(StudyTest, "study: charts go into the result as they are") {
    study["charts"] =
        json::parse(R"([{"name": "main"}, {"name": "light", "title": "Time", "x": "knob light", "y": "time",
        "scenes": ["bright"], "methods": ["coarse"], "knobs": {"looks": 2}, "x_scale": "log"}])");
    CHECK(measure()["charts"] == study["charts"]);
    CHECK(refusal().empty());
}

TEST_CASE_METHOD(StudyTest, "study: a curve sets a scene's knob only where it says that it means that knob") {
    study["curves"].push_back({{"method", "exact"}, {"set", {{"light", {2, 3}}}}});
    CHECK(refusal().find("'light' is set by the scene") != std::string::npos);
    study["curves"].back()["where"] = {{"light", 1}};
    CHECK(refusal().empty());
    const json points = measure()["points"];
    size_t bright = 0;
    for (const json& point : points)
        if (point["scene"] == "bright" && point["knobs"].value("light", 0) >= 2) {
            ++bright;
            CHECK(point["error"]["max"].get<double>() > 0);  // the truth has the scene's own light
        }
    CHECK(bright == 2);
    CHECK(points.size() == 3 + 3 + 2);
    // Another scene's curve may set the same knob.
    study["curves"].back()["where"] = {{"light", 4}};
    study["curves"].back()["set"] = {{"looks", {4}}};
    study["scenes"][1]["set"]["looks"] = 2;
    study["curves"][1].erase("set");
    CHECK(refusal().empty());
}

TEST_CASE_METHOD(StudyTest,
                 "study: a method that knobs make another one of has a name of its own, and says how to draw it") {
    study["curves"] = {{{"method", "coarse"}, {"as", "finest"}, {"set", {{"looks", {4}}}}}};
    const json points = measure()["points"];
    REQUIRE(points.size() == 2);
    for (const json& point : points) {
        CHECK(point["method"] == "finest");
        CHECK(point["knobs"]["method"] == "coarse");
    }
}

TEST_CASE_METHOD(StudyTest, "study: what cannot be is one line with file, line and key") {
    struct Case {
        const char *pointer, *value, *says;
    };
    const Case cases[] = {
        {"/subtitle", "1", R"(key 'subtitle' is unknown here; known: title)"},
        {"/title", "3", "key 'title' is 3, expected a text"},
        {"/size", "[16]", "key 'size' is [16], expected [width, height]"},
        {"/size", "[16, 0]", "from 1 to 16384"},
        {"/rounds", "0", "key 'rounds' is 0"},
        {"/scenes", "[]", "key 'scenes' is []"},
        {"/scenes/1/lights", "3", "key 'lights' is unknown here; known: scene, set, label"},
        {"/scenes/1/set/lamps", "3",
         "key 'lamps': unknown knob 'lamps'; the nearest are samples and looks; --list knobs lists all"},
        {"/scenes/1/set/light", "5", "key 'light': light=5: expected a number from 0 to 4"},
        {"/scenes/1/set/light", "[1, 2]", "key 'light' is [1,2], expected one value"},
        {"/scenes/1/set/looks", "2", "'looks' is set by the scene, so neither a curve nor the truth may set it"},
        {"/scenes/1/set/method", "\"coarse\"", "'method' is set by the scene"},
        {"/scenes/1/label", "\"a\"", "two scenes are called 'a'"},
        {"/scenes/1/label", "7", "key 'label' is 7"},
        {"/scenes/1/scene", "\"none.json\"", "none.json"},
        {"/scenes/1", "4", "is 4, expected a text"},
        {"/curves/1/method", "\"none\"", "method=none: expected one of exact, coarse"},
        {"/curves/1/set/looks", "[1, 0]", "looks=0: expected an integer"},
        {"/curves/1/better", "\"lower\"", "key 'better' is unknown here"},
        {"/truth", R"({"set": {}})", R"(needs "doubled" or "pictures", and "most_change", or "exact": true)"},
        {"/truth", R"({"set": {}, "doubled": {}, "pictures": 4, "most_change": 0})",
         R"(needs "doubled" or "pictures")"},
        {"/truth", R"({"set": {}, "pictures": 3, "most_change": 0})", "key 'pictures' is 3, expected an even integer"},
        {"/truth/pictures", "4", "key 'pictures' does not go with \"exact\""},
        {"/truth", R"({"set": {}, "doubled": {}})", R"(has no "most_change")"},
        {"/truth/exact", "false", "key 'exact' is false, expected true"},
        {"/truth/doubled", "{}", "key 'doubled' does not go with \"exact\""},
        {"/truth/set", "{\"none\": 1}", "unknown knob 'none'"},
        {"/candidates", "[]", "key 'candidates' is []"},
        {"/candidates", R"([{"method": "none"}])", "method=none"},
        {"/candidates", R"([{"method": "exact", "where": {"none": 1}}])", "unknown knob 'none'"},
        {"/budgets", "[-1]", "is -1, expected a number from 0"},
        {"/crops", "1", "key 'crops' is 1, expected true or false"},
        {"/better", R"({"looks": "more"})", "key 'looks' is \"more\", expected \"lower\", \"higher\" or \"either\""},
        {"/better", R"({"none": "lower"})", "unknown knob 'none'"},
        {"/better", "3", "key 'better' is 3"},
        {"/metrics", R"({"width": 3})", "key 'width' is 3"},
        {"/charts", "[{}]", R"(has no "name")"},
        {"/charts", R"([{"name": "a b"}])", "small letters"},
        {"/charts", R"([{"name": "a"}, {"name": "a"}])", "two charts are called 'a'"},
        {"/charts", R"([{"name": "a", "z": 1}])", "key 'z' is unknown here"},
        {"/charts", R"([{"name": "a", "x": "knob none"}])", "unknown knob 'none'"},
        {"/charts", R"([{"name": "a", "y": "knob light"}])", "expected \"time\" or a metric"},
        {"/charts", R"([{"name": "a", "enough": {"at": -1, "text": "x"}}])", "expected a number from 0"},
        {"/charts", R"([{"name": "a", "enough": {"at": 1}}])", R"(has no "text")"},
        {"/charts", R"([{"name": "a", "panel": 1}])", "expected a text"},
        {"/charts", R"([{"name": "a", "knobs": {"looks": [1, 0]}}])", "looks=0: expected an integer"},
        {"/charts", R"([{"name": "a", "knobs": {"none": 1}}])", "unknown knob 'none'"},
        {"/charts", R"([{"name": "a", "x_scale": "cubic"}])", "expected \"linear\" or \"log\""},
        {"/charts", R"([{"name": "a", "scenes": ["b"]}])", "no scene is called 'b'"},
        {"/charts", R"([{"name": "a", "methods": ["b"]}])", "no curve has the method 'b'"},
    };
    const json good = study;
    REQUIRE(refusal().empty());
    for (const Case& c : cases) {
        CAPTURE(c.pointer, c.value);
        study = good;
        study[json::json_pointer(c.pointer)] = json::parse(c.value);
        const std::string said = refusal();
        CHECK_THAT(said, Catch::Matchers::Contains(c.says));
        CHECK_THAT(said, Catch::Matchers::StartsWith("study.json:"));
        CHECK(said.find('\n') == said.npos);
    }
    study = good;
    study.erase("truth");
    CHECK_THAT(refusal(), Catch::Matchers::Contains(R"(has no "truth")"));
    CHECK(chapter.light == 0.25f);  // trying values leaves none behind
}

TEST_CASE("a list of shots is refused at the line of its mistake") {
    const auto said = [](const char* shot) {
        return refusal_of([&] {
            parse_shots(std::string("{\"shots\": [\n{\"name\": \"a\", \"caption\": \"A.\",\n") + shot + "}]}",
                        "shots.json");
        });
    };
    CHECK(said(R"("set": {"steps": 4}, "rejects": [])").empty());
    CHECK(said(R"("frames": 2}, {"caption": "B.")") == R"(shots.json:3: key '1' has no "name")");
    CHECK(said(R"("frames": 2}, {"name": "b")") == R"(shots.json:3: key '1' has no "caption")");
    CHECK(said(R"("frames": 2}, {"name": "b", "caption": "")") == R"(shots.json:3: key '1' has no "caption")");
    CHECK(said(R"("reject": [])") ==
          "shots.json:3: key 'reject' is unknown here; known: name, caption, scene, size, time_s, frames, set, "
          "exercises, "
          "rejects");
    CHECK(said(R"("size": [0, 4])") == "shots.json:3: key 'size' is [0,4], expected two numbers, each from 1 to 16384");
    CHECK(said(R"("set": 4)") == "shots.json:3: key 'set' is 4, expected an object { } of knobs");
}

TEST_CASE("corpus: every study and every list of shots is read or refused") {
    size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(course_root() / "tests/common/corpus/json")) {
        CAPTURE(entry.path());
        const std::string bytes = read_file(entry.path()), text = bytes.substr(1);
        try {
            if (bytes.at(0) == 1)
                read_study(parse_json(text, "test.json"), {});
            else
                parse_shots(text, "test.json");
        } catch (const InputError& error) { CHECK(std::string(error.what()).starts_with("test.json")); }
        ++files;
    }
    CHECK(files >= 4);
}
