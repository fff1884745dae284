// Any time is a picture: however it is reached, it is the same one to the bit.
#include <memory>

#include "../common/file_fixture.h"
#include "19_ambiance/ambiance.h"
#include "common/app/render.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

const char* const short_film = "tests/19_ambiance/short.film";

struct Validated {
    Gpu gpu{DeviceOptions{.validate = true}};
    ~Validated() { CHECK(gpu.device.validation_message_count() == 0); }
};

// A film on a validated device, as it was just started.
struct Started {
    explicit Started(bool plays, int most = 32, const char* film = short_film,
                     std::shared_ptr<Validated> on = std::make_shared<Validated>())
        : device(std::move(on)) {
        chapter.plays = plays;
        chapter.reel.most.value = most;
        load_scene(chapter, gpu, film);
    }
    std::vector<std::byte> picture(double time_s) {
        render(chapter, frame, {{64, 36}, static_cast<float>(time_s), 0, {}});
        return gpu.read_back(frame.output);
    }
    std::shared_ptr<Validated> device;
    Gpu& gpu = device->gpu;
    Ambiance chapter;
    Frame frame{gpu};
};

// A frame before each time at 30 and at 144 a second, then all times backwards, and every `cold_every`th from a cold start;
// of these every `fresh_every`th on a device of its own.
void check_any_time(const char* film, const std::vector<double>& times_s, size_t cold_every, size_t fresh_every) {
    Started played(true, 32, film), played_fast(true, 2, film);
    std::vector<std::vector<std::byte>> pictures;
    for (const double time_s : times_s) {
        played.picture(time_s - 1 / 30.0);
        played_fast.picture(time_s - 1 / 144.0);
        pictures.push_back(played.picture(time_s));
        INFO(time_s);
        CHECK(pictures.back() == played_fast.picture(time_s));
    }
    for (size_t i = times_s.size(); i-- > 0;) {
        INFO(times_s[i]);
        CHECK(played.picture(times_s[i]) == pictures[i]);
    }
    std::shared_ptr<Validated> device;
    for (size_t i = 0; i < times_s.size(); i += cold_every) {
        INFO(times_s[i]);
        if (i / cold_every % fresh_every == 0) device = std::make_shared<Validated>();
        Started cold(false, 32, film, device);
        CHECK(cold.picture(times_s[i]) == pictures[i]);
    }
    size_t alike = 0;
    for (size_t i = 1; i < pictures.size(); ++i) alike += pictures[i] == pictures[i - 1];
    CHECK(alike <= 1);  // black, and black
}

}  // namespace

TEST_CASE("a time is the same picture from a cold start, played at 30 and at 144 a second, and set back to") {
    std::vector<double> times_s;
    for (int i = 0; i < 12; ++i) times_s.push_back(0.25 + i / 2.5);
    check_any_time(short_film, times_s, 3, 1);
}

TEST_CASE("the course's film at 60 times: cold, played at 30 and at 144 a second, set back to", "[.long]") {
    std::vector<double> times_s{61.2, 62, 81, 115};  // cross-fades
    for (int i = 0; i < 56; ++i) times_s.push_back(1.7 + i * 209.0 / 55);
    std::sort(times_s.begin(), times_s.end());
    check_any_time("films/ambiance.film", times_s, 1, 6);
}

TEST_CASE("while it plays, what follows is ready and what is over is dropped; a single picture loads what it shows") {
    Started played(true, 2);
    const auto ready = [&](double time_s) {
        played.picture(time_s);
        played.chapter.reel.wait_until_ready();
        return played.chapter.reel.parts().size();
    };
    CHECK(ready(0.25) == 2);
    CHECK(ready(2.5) == 2);
    CHECK(!played.chapter.reel.parts().contains(0));
    Started cold(false);
    cold.picture(1);
    CHECK(cold.chapter.reel.parts().size() == 1);
    cold.picture(1.75);
    CHECK(cold.chapter.reel.parts().size() == 2);
}

TEST_CASE("the film's tracks set the chapter's knobs, but what the command line has set") {
    Started started(false);
    Ambiance& film = started.chapter;
    film.reel.apply_knobs(film, 0.5);
    CHECK(float(film.smoothed) == Approx(0.75f));
    CHECK(film.post.grain.is("white"));
    film.smoothed.value = 0.25f;
    film.smoothed.pinned = true;
    film.reel.apply_knobs(film, 3.5);
    CHECK(float(film.smoothed) == 0.25f);
    CHECK(film.post.aberration);
}

TEST_CASE("a fade to black ends in black, a gap is black, and the sun outlives the rest") {
    Started started(false);
    const auto brightest = [](const std::vector<std::byte>& picture) {
        int most = 0;
        for (size_t i = 0; i < picture.size(); ++i)
            if (i % 4 != 3) most = std::max(most, int(picture[i]));
        return most;
    };
    CHECK(brightest(started.picture(0)) == 0);
    CHECK(brightest(started.picture(9)) == 0);
    CHECK(brightest(started.picture(0.5)) > 100);
}

TEST_CASE("what is over is kept while there is room: a cut frees nothing") {
    Started played(true, 8);
    for (const double time_s : {0.25, 2.5, 4.0}) played.picture(time_s);
    played.chapter.reel.wait_until_ready();
    CHECK(played.chapter.reel.parts().size() == 3);
}

TEST_CASE("a scene by other knobs is another picture, and the same again as the film says") {
    Started started(false);
    const auto as_set = started.picture(1);
    started.chapter.reel.draw_by(0, {{"bloom.method", "none"}});
    CHECK(started.picture(1) != as_set);
    started.chapter.reel.draw_by(0, {});
    CHECK(started.picture(1) == as_set);
}

TEST_CASE("a scene of a film that does not exist, and a knob that nobody has, are named with their line") {
    Gpu gpu(DeviceOptions{});
    Ambiance chapter;
    const auto error = [&](const std::string& knobs, const std::string& scene) {
        const FilmScene parsed =
            parse_timeline(fmt::format("{{\"duration_s\": 1, \"scenes\": [\n{{\"name\": \"a\", \"kind\": \"julia\", "
                                       "\"scene\": \"{}\", \"from_s\": 0, \"to_s\": 1, \"knobs\": {{{}}}}}]}}",
                                       scene, knobs),
                           "a.film")
                .scenes.at(0);
        return refusal_of([&] { FilmPart(parsed).load(gpu); });
    };
    const std::string good = "scenes/julia_sunset.json";
    CHECK(error("", "scenes/julia_sunrise.json").find("a.film:2: key 'scene': no file scenes/julia_sunrise.json") == 0);
    CHECK(error("\"julia.slise\": 1", good).find("a.film:2: key 'julia.slise': ") == 0);
    CHECK(error("\"julia.slice\": 9", good).find("a.film:2: key 'julia.slice': ") == 0);
    CHECK(error("", good).empty());
}

TEST_CASE(
    "the worker makes a film's later scenes while the first is drawn, and a time stays the same picture, with one "
    "frame in flight or two") {
    const auto pictures = [](bool waits, size_t in_flight) {
        Gpu gpu(DeviceOptions{.validate = true});
        Ambiance chapter;
        chapter.plays = true;
        load_scene(chapter, gpu, "tests/19_ambiance/short.film");
        Frame frame(gpu);
        frame.set_frames_in_flight(in_flight);
        std::vector<std::vector<std::byte>> all;
        for (const double time_s : {0.25, 0.5, 1.0, 1.75, 2.5, 3.75, 4.75}) {
            render(chapter, frame, {{64, 36}, static_cast<float>(time_s), 0, {}});
            if (all.empty()) CHECK(chapter.reel.parts().size() < 3);
            if (waits) chapter.reel.wait_until_ready();
            all.push_back(gpu.read_back(frame.output));
        }
        chapter.reel.wait_until_ready();
        CHECK(chapter.reel.parts().size() == 3);
        CHECK(gpu.device.validation_message_count() == 0);
        return all;
    };
    const auto right = pictures(true, 2);
    CHECK(pictures(false, 2) == right);
    CHECK(pictures(true, 1) == right);
}

TEST_CASE("the same scenes are shown since the last cut, or the end of a cross-fade") {
    const Started started(false);  // 0 to 2, 1.5 to 3.5, 3.5 to 5 s
    const Reel& reel = started.chapter.reel;
    CHECK(reel.steady_from_s(1) == 0);
    CHECK(reel.steady_from_s(1.75) == 1.5);
    CHECK(reel.steady_from_s(3) == 2);
    CHECK(reel.steady_from_s(4) == 3.5);
}

TEST_CASE("cameras of an edited film move as was chosen for all of them") {
    Started started(false, 32, "tests/19_ambiance/path_loop.film");
    Reel& reel = started.chapter.reel;
    reel.choose(PathKind{Spline::linear, 0});
    Timeline edited = reel.film();
    CameraPath& path = edited.scenes.at(0).camera;
    std::vector<CameraKey> keys = path.keys();
    keys.at(1).position = {4, 2, 0};
    path = CameraPath(keys, PathKind{});
    REQUIRE(reel.take_cameras(edited));
    const glm::dvec3 middle = 0.5 * (keys[0].position + keys[1].position);
    const double half_s = 0.5 * (keys[0].time_s + keys[1].time_s);
    CHECK(glm::distance(reel.film().scenes[0].camera.eye(half_s), middle) < 1e-9);
    edited.scenes[0].to_s += 1;
    CHECK_FALSE(reel.take_cameras(edited));
}
