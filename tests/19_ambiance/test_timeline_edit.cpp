// Keys written into a film's text: the rest stays unchanged, to the byte.
#include "../catch.h"
#include "19_ambiance/timeline.h"
#include "common/base/error.h"
#include "common/base/files.h"

using namespace lightwalk;

namespace {

const std::string three_scenes = R"({
	"duration_s": 60, "titles": [{"from_s": 1, "to_s": 2, "text": "keys: [{ \" }]"}],
	"scenes": [
		{
			"name": "a", "kind": "julia", "scene": "scenes/julia_sunset.json", "from_s": 0, "to_s": 20,
			"camera": {"spline": "linear", "keys": [
				{"time_s": 0, "position": [0.9, 0.5, 2.9], "target": [0, 0, 0]},
				{"time_s": 8, "position": [2.3, 0.9, 1.3], "target": [0, 0, 0]}
			]}
		},
		{"name": "b", "kind": "julia", "scene": "scenes/julia_sunset.json", "from_s": 20, "to_s": 30, "camera": {"keys": [{"time_s": 5, "position": [1, 2, 3], "target": [0, 0, 0]}]}},
		{
			"name": "c", "kind": "julia", "scene": "scenes/julia_sunset.json", "from_s": 30, "to_s": 60,
			"knobs": {"julia.slice": [[0, 1], [4, 1.5]]}
		}
	]
}
)";

CameraKey key(double time_s, glm::dvec3 position) { return {.time_s = time_s, .position = position}; }

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all{""};
    for (const char c : text) c == '\n' ? void(all.emplace_back()) : all.back().push_back(c);
    return all;
}

// Lines of `b` that are not in `a`, where all of a's are in b in order; else "other".
std::vector<std::string> added(const std::string& a, const std::string& b) {
    const std::vector<std::string> from = lines(a), to = lines(b);
    std::vector<std::string> more;
    size_t at = 0;
    for (const std::string& line : to) at < from.size() && line == from[at] ? void(++at) : more.push_back(line);
    return at == from.size() ? more : std::vector<std::string>{"other"};
}

const std::vector<CameraKey>& keys_of(const std::string& text, size_t scene) {
    static Timeline parsed;
    parsed = parse_timeline(text, "a.film");
    return parsed.scenes.at(scene).camera.keys();
}

}  // namespace

TEST_CASE("a key between two others is one line more") {
    const std::string edited = with_key(three_scenes, 0, key(4.5, {1.23456, -0.0001, 1e-9}), 0.01);
    CHECK(added(three_scenes, edited) ==
          std::vector<std::string>{"\t\t\t\t{\"time_s\": 4.5, \"position\": [1.235, 0, 0], \"target\": [0, 0, 0]},"});
    REQUIRE(keys_of(edited, 0).size() == 3);
    CHECK(keys_of(edited, 0)[1].time_s == 4.5);
    CHECK(without_key(edited, 0, 4.5, 0.01) == three_scenes);  // and gone again, to the byte
}

TEST_CASE("a key before all, and one after all") {
    CHECK(added(three_scenes, with_key(three_scenes, 0, key(-1, {0, 0, 1}), 0.01)).size() == 1);
    const std::string last = with_key(three_scenes, 0, key(12, {0, 0, 1}), 0.01);
    REQUIRE(keys_of(last, 0).size() == 3);
    CHECK(keys_of(last, 0)[2].time_s == 12);
    CHECK(lines(last).size() == lines(three_scenes).size() + 1);
    CHECK(without_key(last, 0, 12, 0.01) == three_scenes);
}

TEST_CASE("a key near another takes its place, and nothing else is another") {
    CameraKey other = key(7.99, {5, 5, 5});
    other.up = {0, 2, 2};
    other.fov_deg = 33.33333;
    const std::string edited = with_key(three_scenes, 0, other, 0.02);
    REQUIRE(keys_of(edited, 0).size() == 2);
    CHECK(keys_of(edited, 0)[1].position == glm::dvec3(5, 5, 5));
    CHECK(keys_of(edited, 0)[1].fov_deg == Approx(33.333));
    CHECK(keys_of(edited, 0)[1].up.z == Approx(0.707));
    size_t changed = 0;
    for (size_t i = 0; i < lines(three_scenes).size(); ++i) changed += lines(three_scenes)[i] != lines(edited).at(i);
    CHECK(changed == 1);
}

TEST_CASE("keys in one line stay in one line; a scene without a camera gets one") {
    const std::string in_line = with_key(three_scenes, 1, key(2, {0, 1, 0.5}), 0.01);
    CHECK(lines(in_line).size() == lines(three_scenes).size());
    CHECK(keys_of(in_line, 1).size() == 2);
    const std::string first = with_key(three_scenes, 2, key(3, {0, 1, 0.5}), 0.01);
    REQUIRE(keys_of(first, 2).size() == 1);
    CHECK(lines(first).size() == lines(three_scenes).size() + 3);
    CHECK(first.find("\t\t\t\"camera\": {\"keys\": [\n\t\t\t\t{\"time_s\": 3, ") != std::string::npos);
    CHECK(keys_of(with_key(first, 2, key(5, {0, 1, 0}), 0.01), 2).size() == 2);
}

TEST_CASE("what cannot be removed is said") {
    CHECK_THROWS_WITH(without_key(three_scenes, 0, 4, 0.01), "there is no key within 0.01 s of 4 s");
    CHECK_THROWS_WITH(without_key(three_scenes, 2, 4, 0.01), "there is no key within 0.01 s of 4 s");
    CHECK_THROWS_WITH(without_key(three_scenes, 1, 5, 0.01), "it is the scene's only key");
}

TEST_CASE("the course's film takes a key in each of its scenes and gives it back, to the byte") {
    const std::string text = read_file(find_asset("films/ambiance.film"));
    const Timeline parsed = parse_timeline(text, "ambiance.film");
    for (size_t i = 0; i < parsed.scenes.size(); ++i) {
        const FilmScene& scene = parsed.scenes[i];
        const double at_s = scene.clock_s + 0.3 * (scene.to_s - scene.from_s) + 0.0123;
        const std::string edited = with_key(text, i, key(at_s, {1, 2, 3}), 0.01);
        INFO(scene.name);
        CHECK(keys_of(edited, i).size() == scene.camera.keys().size() + 1);
        if (!scene.camera.empty()) CHECK(without_key(edited, i, at_s, 0.01) == text);
    }
}
