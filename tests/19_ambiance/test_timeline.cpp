// The film's file: contents and mistakes.
#include "../common/file_fixture.h"
#include "19_ambiance/timeline.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

std::string film(const std::string& inside) { return "{\"duration_s\": 60,\n" + inside + "\n}"; }

std::string scene(const std::string& name, double from, double to, const std::string& more = "") {
    return fmt::format(
        R"({{"name": "{}", "kind": "julia", "scene": "scenes/julia_sunset.json", "from_s": {}, "to_s": {}{}}})", name,
        from, to, more);
}

Timeline read(const std::string& inside) { return parse_timeline(film(inside), "a.film"); }

std::string error_of(const std::string& text) {
    return refusal_of([&] { parse_timeline(text, "a.film"); });
}

}  // namespace

TEST_CASE("a film's errors name file, line and key, and what would be right") {
    const auto scenes = [](const std::string& list) { return film("\"scenes\": [" + list + "]"); };
    const std::pair<std::string, std::string> wrong[] = {
        {"{", "a.film:1: not JSON"},
        {"{}", "lacks duration_s"},
        {"{\"duration_s\": 0}", "a.film:1: key 'duration_s' is 0, expected 0.1 to 3600"},
        {film("\"scene\": []"), "a.film:2: key 'scene' is unknown here; known: "},
        {scenes("{}"), "a.film:2: key '0' lacks name"},
        {scenes("{\"name\": \"a\", \"kind\": \"clouds\"}"), "key 'kind' is 'clouds', expected descent, "},
        {scenes(scene("a", 5, 5)), "key 'to_s' is not after from_s"},
        {scenes(scene("a", 0, 61)), "key 'to_s' is 61, expected 0.0 to 60.0"},
        {scenes(scene("a", 0, 5) + "," + scene("a", 5, 6)), "key 'name' is 'a', as another scene is"},
        {scenes(scene("a", 5, 9) + "," + scene("b", 4, 10)), "key 'from_s' is before the beginning"},
        {scenes(scene("a", 5, 9) + "," + scene("b", 6, 8)), "key 'to_s' is before the end"},
        {scenes(scene("a", 0, 9) + "," + scene("b", 4, 10) + "," + scene("c", 8, 12)), "three scenes at once"},
        {scenes(scene("a", 0, 9, R"(, "camera": {"keys": []})")), "lacks keys"},
        {scenes(scene("a", 0, 9, R"(, "camera": {"spline": "bezier", "keys": []})")), "is 'bezier', expected linear, "},
        {scenes(scene("a", 0, 9, R"(, "camera": {"keys": [{"time_s": 0, "position": [0,0,1]}]})")), "lacks target"},
        {scenes(scene("a", 0, 9,
                      R"(, "camera": {"keys": [{"time_s": 1, "position": [0,0,1], "target": [0,0,0]},
                          {"time_s": 1, "position": [0,0,1], "target": [0,0,0]}]})")),
         "a.film:3: key 'time_s' does not come after the key before"},
        {scenes(scene("a", 0, 9, R"(, "knobs": {"slice": [[0, 1], [0, 2]]})")), "does not come after the one before"},
        {scenes(scene("a", 0, 9, R"(, "knobs": {"slice": [[0, {}]]})")), "must be a number, three numbers, a text"},
        {film(R"("fades": [{"from_s": 5, "to_s": 4, "from": 0, "to": 1}])"), "key 'to_s' is 4, expected 5.0 to 60.0"},
        {film(R"("fades": [{"from_s": 5, "to_s": 6, "from": 0, "to": 1, "color": "red"}])"),
         "key 'color' is 'red', expected black or white"},
        {film(R"("titles": [{"from_s": 5, "to_s": 6}])"), "lacks text"},
        {film(R"("cuts": {"short": {}})"), "a.film:2: key 'short' lacks parts"},
        {film(R"("cuts": {"short": {"parts": [[5, 61]]}})"), "must be pairs [from, to] within 0 and 60.0 s"},
        {film(R"("titles": [{"from_s": 5, "to_s": 6, "text": "a", "at": [1]}])"), "key 'at' must be two numbers"}};
    for (const auto& [text, words] : wrong) {
        INFO(text << "\n" << error_of(text));
        CHECK(error_of(text).find(words) != std::string::npos);
    }
}

TEST_CASE("a cut shows one scene, a cross-fade two whose shares are 1 together, a gap none") {
    const Timeline film = read("\"scenes\": [" + scene("a", 0, 10) + "," + scene("b", 10, 20) + "," +
                               scene("c", 16, 30) + "," + scene("d", 40, 50) + "]");
    CHECK(film.shown(9.999).size() == 1);
    CHECK(film.shown(10).at(0).scene == 1);
    CHECK(film.shown(35).empty());
    CHECK(film.shown(-1).empty());
    CHECK(film.shown(50).empty());
    float before = 0;
    for (double t = 16; t < 20; t += 0.125) {
        const auto shown = film.shown(t);
        REQUIRE(shown.size() == 2);
        CHECK(shown[0].share + shown[1].share == 1.0f);
        CHECK(shown[1].share >= before);
        before = shown[1].share;
    }
    CHECK(film.shown(16)[1].share == 0.0f);
    CHECK(film.shown(18)[1].share == 0.5f);
    CHECK(film.shown(17)[1].share == Approx(0.15625f));  // 3 s² - 2 s³ of a quarter
}

TEST_CASE("a third scene may begin where the first one ends") {
    const Timeline film =
        read("\"scenes\": [" + scene("a", 0, 5) + "," + scene("b", 4, 8) + "," + scene("c", 5, 9) + "]");
    CHECK(film.shown(5).size() == 2);
}

TEST_CASE("fades last until the next one of their colour") {
    const Timeline film = read(R"("fades": [{"from_s": 0, "to_s": 2, "from": 1, "to": 0},
        {"from_s": 10, "to_s": 12, "from": 0, "to": 1, "color": "white"}, {"from_s": 20, "to_s": 20, "from": 0, "to": 1}])");
    CHECK(film.faded(0).black == 1.0f);
    CHECK(film.faded(1).black == 0.5f);
    CHECK(film.faded(11).white == 0.5f);
    CHECK(film.faded(11).black == 0.0f);
    CHECK(film.faded(59).white == 1.0f);
    CHECK(film.faded(20).black == 1.0f);
}

TEST_CASE("tracks run evenly between numbers, jump between words, and rest outside") {
    const Timeline film = read("\"scenes\": [" + scene("a", 0, 10, R"(, "knobs": {"slice": [[0, 1], [4, 3]],
        "look.color": [[0, [0, 0, 0]], [2, [1, 0.5, 0]]], "show": ["steps", [0, "picture"], [3, "normals"]],
        "trust": ["steps", [0, 0.5], [1, 1]], "shadow": false})") +
                               "]");
    std::map<std::string, const Track*> tracks;
    for (const Track& track : film.scenes[0].knobs) tracks[track.name] = &track;
    CHECK(tracks.at("slice")->at(-5) == "1");
    CHECK(tracks.at("slice")->at(1) == "1.5");
    CHECK(tracks.at("slice")->at(9) == "3");
    CHECK(tracks.at("look.color")->at(1) == "0.5,0.25,0");
    CHECK(tracks.at("show")->at(2.999) == "picture");
    CHECK(tracks.at("show")->at(3) == "normals");
    CHECK(tracks.at("trust")->at(0.9) == "0.5");
    CHECK(tracks.at("shadow")->at(7) == "off");
}

TEST_CASE("an entry has begun in the frame whose time, a float, rounds to just before it") {
    const Timeline film = read("\"scenes\": [" + scene("a", 36, 60, R"(, "knobs": {"slice": [[14.3, 1], [20, 3]],
        "show": ["steps", [0, "picture"], [14.3, "normals"]]})") +
                               "]");
    const double frame_s = double(50.3f) - 36;
    REQUIRE(frame_s < 14.3);
    std::map<std::string, const Track*> tracks;
    for (const Track& track : film.scenes[0].knobs) tracks[track.name] = &track;
    CHECK(tracks.at("show")->at(frame_s) == "normals");
    CHECK(tracks.at("show")->at(14.299) == "picture");
    CHECK(tracks.at("slice")->at(frame_s) == "1");
}

TEST_CASE("a scene turns where it begins and where a track jumps, not where one runs") {
    const Timeline film =
        read("\"scenes\": [" + scene("a", 10, 20, R"(, "clock_s": 3, "knobs": {"slice": [[3, 1], [7, 3]],
        "show": ["steps", [3, "picture"], [8, "normals"], [90, "depth"]], "trust": ["steps", [3, 0.5], [5, 1]],
        "method": [[3, "a"], [8, "b"]]})") +
             "]");
    CHECK(film.turns(0) == std::vector<double>{10, 12, 15});
}

TEST_CASE("a scene turns at its camera's keys, from which other things are seen") {
    const Timeline film = read("\"scenes\": [" + scene("a", 10, 20, R"(, "clock_s": 3, "camera": {"keys": [
        {"time_s": 3, "position": [0, 0, 9], "target": [0, 0, 0]}, {"time_s": 7, "position": [9, 0, 9], "target": [0, 0, 0]},
        {"time_s": 13, "position": [9, 0, 0], "target": [0, 0, 0]}]})") +
                               "]");
    CHECK(film.turns(0) == std::vector<double>{10, 14, 20 - 0.01});
}

TEST_CASE("tracks of the whole film run in its time, and their errors name their line") {
    const Timeline film = read(R"("knobs": {"post.grain": "white", "post.grain_by": [[0, 0.02], [50, 0]]})");
    REQUIRE(film.knobs.size() == 2);
    CHECK(film.knobs[1].at(25) == "0.01");
    CHECK(error_of(R"({"duration_s": 9, "knobs": {
        "smoothed": [[3, 1], [3, 0]]}})")
              .find("a.film:2: key 'smoothed' has an entry at 3 s") == 0);
}

TEST_CASE("titles come and go, and count") {
    const Title title{.from_s = 10, .to_s = 20, .text = "{} lights", .count = glm::dvec2(0, 12345)};
    CHECK(title_strength(title, 9.9) == 0.0f);
    CHECK(title_strength(title, 10.3) == 0.5f);
    CHECK(title_strength(title, 15) == 1.0f);
    CHECK(title_strength(title, 20.1) == 0.0f);
    CHECK(title_text(title, 10) == "0 lights");
    CHECK(title_text(title, 20) == "12,345 lights");
    const Title falls{.from_s = 0, .to_s = 10, .text = "{} m", .count = glm::dvec2(-123, -1234567)};
    CHECK(title_text(falls, 0) == "-123 m");
    CHECK(title_text(falls, 10) == "-1,234,567 m");
    const Timeline film = read(R"("titles": [{"from_s": 50, "to_s": 60, "text": "the end"}])");
    CHECK(title_strength(film.titles[0], 60) == 1.0f);
    CHECK(title_strength(film.titles[0], 60.01) == 0.0f);
}

TEST_CASE("the course's film: two scenes at most at any time, and none missing") {
    const Timeline film = read_timeline(find_asset("films/ambiance.film"));
    for (int i = 0; i < 60 * 218; ++i) {
        const size_t on = film.shown(i / 60.0).size();
        REQUIRE((on == 1 || on == 2));
    }
    CHECK(film.scenes.size() == 15);
}

TEST_CASE("each scene of the course's film has a title that names the chapter that says how it is made") {
    const std::map<std::string, std::string> chapters{{"planets", "17: planets"}, {"descent", "10: atmosphere"},
                                                      {"volume", "16: volume"},   {"julia", "11: fractals"},
                                                      {"head", "12: skin"},       {"water", "15: terrain and water"},
                                                      {"street", "06: deferred"}, {"surroundings", "14: environment"},
                                                      {"lights", "06: deferred"}};
    const Timeline film = read_timeline(find_asset("films/ambiance.film"));
    for (const FilmScene& scene : film.scenes) {
        double longest_s = 0;
        for (const Title& title : film.titles)
            if (title.text.find(chapters.at(scene.kind)) != std::string::npos && title.from_s >= scene.from_s &&
                title.to_s <= scene.to_s)
                longest_s = std::max(longest_s, title.to_s - title.from_s);
        INFO(scene.name);
        CHECK(longest_s > 3);
    }
}
