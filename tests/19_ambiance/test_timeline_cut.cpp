// Cuts of a film: at each time the whole film's picture of the time in the cut's list.
#include "../catch.h"
#include "19_ambiance/timeline.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

// The time of the whole film that a cut shows, by its list.
double whole_time(const Cut& cut, double time_s) {
    for (const glm::dvec2 part : cut.parts) {
        if (time_s < part.y - part.x) return part.x + time_s;
        time_s -= part.y - part.x;
    }
    return cut.parts.back().y;
}

}  // namespace

TEST_CASE("the short cut lasts 90 s and shows the whole film's scenes, clocks, fades and knobs", "[short_cut]") {
    const Timeline film = read_timeline(find_asset("films/ambiance.film"));
    const Timeline cut = cut_of(film, "short");
    CHECK(cut.duration_s == 90.0);
    for (int i = 0; i < 900; ++i) {
        const double time_s = 0.1 * i + 0.03, whole_s = whole_time(film.cuts.at("short"), time_s);
        INFO(time_s << " s, " << whole_s << " s of the whole");
        const auto shown = cut.shown(time_s), expected = film.shown(whole_s);
        REQUIRE(shown.size() == expected.size());
        for (size_t k = 0; k < shown.size(); ++k) {
            const FilmScene &a = cut.scenes[shown[k].scene], &b = film.scenes[expected[k].scene];
            CHECK(a.name.rfind(b.name, 0) == 0);
            CHECK(std::abs(a.clock_at(time_s) - b.clock_at(whole_s)) < 1e-9);
        }
        CHECK(std::abs(cut.faded(time_s).black - film.faded(whole_s).black) < 1e-6f);
        for (size_t k = 0; k < film.knobs.size(); ++k)
            if (film.knobs[k].steps) CHECK(cut.knobs[k].at(time_s) == film.knobs[k].at(whole_s));
    }
}

TEST_CASE("the short cut's sphere and end hear what the whole film's hear", "[short_cut]") {
    const Timeline film = read_timeline(find_asset("films/ambiance.film")), cut = cut_of(film, "short");
    for (const FilmScene& scene : cut.scenes)
        if (scene.name == "sphere") CHECK(cut.music.from_s + scene.from_s == scene.clock_s);
    CHECK(cut.music.from_s + cut.duration_s == film.duration_s);
}

TEST_CASE("the cuts between scenes stand on the music's beats", "[beats]") {
    const Timeline film = read_timeline(find_asset("films/ambiance.film"));
    for (const Timeline& one : {film, cut_of(film, "short")})
        for (const FilmScene& scene : one.scenes) {
            INFO(scene.name << " from " << scene.from_s);
            CHECK(std::abs(std::remainder(scene.from_s, 0.5)) < 1e-9);  // 120 beats a minute
        }
}

TEST_CASE("a fade and a count that begin before a part go on in it; a title of less than 1.5 s is left out") {
    const Timeline film =
        parse_timeline(R"({"duration_s": 60, "cuts": {"short": {"parts": [[10, 20]], "music_from_s": 0}},
        "fades": [{"from_s": 8, "to_s": 10.5, "from": 1, "to": 0, "color": "black"}],
        "titles": [{"from_s": 8, "to_s": 14, "text": "{}", "count": [0, 600]},
                   {"from_s": 9, "to_s": 11.4, "text": "short"}]})",
                       "a.film");
    const Timeline cut = cut_of(film, "short");
    for (const double time_s : {0.0, 0.2, 0.4, 0.6, 5.0})
        CHECK(cut.faded(time_s).black == Approx(film.faded(10 + time_s).black).margin(1e-6));
    REQUIRE(cut.titles.size() == 1);
    for (const double time_s : {0.5, 2.0, 3.5})
        CHECK(title_text(cut.titles[0], time_s) == title_text(film.titles[0], 10 + time_s));
}

TEST_CASE("a cut that a film does not have is one line") {
    CHECK_THROWS_WITH(cut_of(parse_timeline("{\"duration_s\": 5}", "a.film"), "short"),
                      "a.film: the film has no cut 'short'");
}
