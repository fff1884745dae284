// The film's benchmark: the frames it plays, and their figures.
#include <nlohmann/json.hpp>

#include "../catch.h"
#include "19_ambiance/benchmark.h"

using namespace lightwalk;

namespace {

// Two scenes of two seconds with a hard cut at 2 s.
Timeline two_scenes() {
    Timeline film;
    film.duration_s = 4;
    film.scenes.resize(2);
    film.scenes[0].name = "first";
    film.scenes[0].from_s = 0;
    film.scenes[0].to_s = 2;
    film.scenes[1].name = "second";
    film.scenes[1].from_s = 2;
    film.scenes[1].to_s = 4;
    return film;
}

}  // namespace

TEST_CASE("all frames are played in order, or the first second, six after each cut, and as many as asked for") {
    const std::vector<int> all = played_numbers(two_scenes(), {});
    CHECK(all.size() == 240);
    CHECK(all.back() == 239);
    const std::vector<int> some = played_numbers(two_scenes(), 2);
    CHECK(some.size() == 60 + 1 + 6 + 2);  // one of the first scene's two lies within the first second
    CHECK(std::is_sorted(some.begin(), some.end()));
    for (const int number : {0, 59, 90, 120, 125, 150, 210}) CHECK(std::count(some.begin(), some.end(), number) == 1);
}

TEST_CASE("a hitch at a cut, a slow start and a first compilation are each said where they are") {
    const Timeline film = two_scenes();
    std::vector<PlayedFrame> frames;
    for (const int number : played_numbers(film, {}))
        frames.push_back({.number = number,
                          .wall_ms = 4,
                          .processor_ms = 0.5,
                          .gpu_ms = 3,
                          .scene = static_cast<size_t>(number / 120)});
    frames[0].wall_ms = 2500;  // since the program started
    frames[7].wall_ms = 40;    // in the first second
    frames[122].wall_ms = 12;  // third after the cut
    frames[122].processor_ms = 9;
    frames[200].wall_ms = 8;  // long after it
    const nlohmann::json said = played_figures(film, frames);
    CHECK(said["in_order"]["first_frame_s"] == 2.5);
    CHECK(said["in_order"]["first_second_longest_ms"] == 40.0);
    CHECK(said["in_order"]["longest_ms"] == 40.0);
    CHECK(double(said["in_order"]["mean_ms"]) == Approx((239 * 4 + 36 + 8 + 4) / 239.0));
    CHECK(said["in_order"]["processor_ms"] == 0.5);
    CHECK(double(said["in_order"]["gpu_ms"]) == Approx(3));
    const nlohmann::json cut = said["cuts"].at(0), second = said["scenes"].at(1);
    CHECK(said["cuts"].size() == 1);
    CHECK(cut["to"] == "second");
    CHECK(cut["frames_ms"] == nlohmann::json({4.0, 4.0, 12.0, 4.0, 4.0, 4.0}));
    CHECK(cut["longest_ms"] == 12.0);
    CHECK(second["longest_ms"] == 12.0);
    CHECK(double(second["mean_ms"]) == Approx((120 * 4 + 8 + 4) / 120.0));
    CHECK(cut["mean_ms"] == second["mean_ms"]);
}
