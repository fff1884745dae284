// Any time is a picture: however it is reached, it is the same one to the bit.
#include "../catch.h"
#include "01_obj/model_chapter.h"
#include "19_ambiance/reel.h"
#include "common/app/render.h"

using namespace lightwalk;

namespace {

const char* const file = "tests/19_ambiance/short.film";

struct ShortFilm : ModelChapter {
    Reel reel{*this, "reel"};
    std::string default_scene() const override { return file; }
    Model load_model(const std::filesystem::path&) override {
        Model none;
        none.materials.emplace_back();
        return none;
    }
    void make_ready(Gpu& gpu, glm::uvec2 size, float time_s) override {
        reel.make_ready(gpu, size, static_cast<double>(time_s), 0.0, plays);
    }
    void frame(Frame& frame) override {
        reel.record(frame, static_cast<double>(frame.time_s));
        reel.record_titles(frame, frame.hdr, static_cast<double>(frame.time_s));
        encode_srgb(frame);
    }
};

// The film on a validated device, as it was just started.
struct Started {
    explicit Started(bool plays, int most = 32) : gpu(DeviceOptions{.validate = true}) {
        chapter.plays = plays, chapter.reel.most.value = most;
        load_scene(chapter, gpu, file);
    }
    ~Started() { CHECK(gpu.device.validation_message_count() == 0); }
    std::vector<std::byte> picture(double time_s) {
        render(chapter, frame, {{64, 36}, static_cast<float>(time_s), 0, {}});
        return gpu.read_back(frame.output);
    }
    Gpu gpu;
    ShortFilm chapter;
    Frame frame{gpu};
};

constexpr double times_s[] = {0.25, 1, 1.75, 2.5, 4, 4.75};

}  // namespace

TEST_CASE("a time is the same picture from a cold start, played at 30 and at 144 a second, and set back to") {
    Started played(true), played_fast(true, 2);
    std::map<double, std::vector<std::byte>> pictures;
    for (const double time_s : times_s) {
        // Frames before it, at either rate, as many as a change of scene takes.
        for (int i = 4; i > 0; --i) played.picture(time_s - i / 30.0), played_fast.picture(time_s - i / 144.0);
        pictures[time_s] = played.picture(time_s);
        CHECK(pictures[time_s] == played_fast.picture(time_s));
    }
    for (auto it = pictures.rbegin(); it != pictures.rend(); ++it) CHECK(played.picture(it->first) == it->second);
    for (const double time_s : times_s) {
        Started cold(false);
        INFO(time_s);
        CHECK(cold.picture(time_s) == pictures.at(time_s));
    }
    CHECK(pictures.at(1) != pictures.at(2.5));
}

TEST_CASE("while it plays, what follows is ready and what is over is dropped; a single picture loads what it shows") {
    Started played(true, 2);
    played.picture(0.25);
    CHECK(played.chapter.reel.parts().size() == 2);
    played.picture(2.5);
    CHECK(played.chapter.reel.parts().size() == 2);
    CHECK(!played.chapter.reel.parts().contains(0));
    Started cold(false);
    cold.picture(1);
    CHECK(cold.chapter.reel.parts().size() == 1);
    cold.picture(1.75);
    CHECK(cold.chapter.reel.parts().size() == 2);
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

TEST_CASE("a scene of a film that does not exist, and a knob that nobody has, are named with their line") {
    Gpu gpu(DeviceOptions{});
    ShortFilm chapter;
    const auto error = [&](const std::string& knobs, const std::string& scene) {
        const FilmScene parsed =
            parse_timeline(fmt::format("{{\"duration_s\": 1, \"scenes\": [\n{{\"name\": \"a\", \"kind\": \"julia\", "
                                       "\"scene\": \"{}\", \"from_s\": 0, \"to_s\": 1, \"knobs\": {{{}}}}}]}}",
                                       scene, knobs),
                           "a.film")
                .scenes.at(0);
        try {
            make_part(parsed, chapter.reel.music)->load(gpu);
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string("no error");
    };
    const std::string good = "scenes/julia_sunset.json";
    CHECK(error("", "scenes/julia_sunrise.json").find("a.film:2: key 'scene': no file scenes/julia_sunrise.json") == 0);
    CHECK(error("\"julia.slise\": 1", good).find("a.film:2: key 'julia.slise': ") == 0);
    CHECK(error("\"julia.slice\": 9", good).find("a.film:2: key 'julia.slice': ") == 0);
    CHECK(error("", good) == "no error");
}
