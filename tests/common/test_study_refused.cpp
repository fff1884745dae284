// Errors of study.json and of lists of shots.
#include "common/app/shots.h"
#include "study_fixture.h"

using namespace lightwalk;
using nlohmann::json;

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
