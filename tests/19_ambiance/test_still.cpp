// Uploads of a frame without motion: the view alone.
#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "../catch.h"
#include "19_ambiance/ambiance.h"
#include "common/app/render.h"
#include "common/gpu/gpu_work.h"

using namespace lightwalk;

namespace {

// Draws a film at a time until nothing changes, and once more.
struct Still {
    explicit Still(const char* film) : gpu(DeviceOptions{}) { load_scene(chapter, gpu, film); }

    void draw(double time_s) { render(chapter, frame, {{64, 36}, static_cast<float>(time_s), 0, {}}); }

    /// `lists`: macro lists that one frame makes at most, of modules that it draws with in several ways.
    void check(double time_s, uint64_t lists = 0) {
        INFO(time_s);
        for (int i = 0; i < 4; ++i) draw(time_s);  // images take turns
        const uint64_t uploaded = gpu.uploaded_bytes;
        const std::vector<PassTime> before = frame.times;
        const GpuWork work = gpu_work;
        draw(time_s);
        CHECK(gpu.uploaded_bytes == uploaded);
        CHECK(gpu_work.macro_lists - work.macro_lists <= lists);
        CHECK(gpu_work.searches == work.searches);
        CHECK(gpu_work.sets == work.sets);
        CHECK(gpu_work.command_buffers == work.command_buffers);
        CHECK(gpu_work.allocations == work.allocations);
        for (const PassTime& pass : frame.times) {
            INFO(pass.name);
            // Of a land's chunks the view decides; the command that draws them is reset where the device has it.
            CHECK((pass.stage != "transfer" || pass.name == "chunk draws"));
        }
        REQUIRE(frame.times.size() == before.size());
        for (size_t i = 0; i < before.size(); ++i) CHECK(frame.times[i].name == before[i].name);
    }
    Gpu gpu;
    Ambiance chapter;
    Frame frame{gpu};
};

}  // namespace

TEST_CASE("where nothing moves nothing is uploaded, and no macros, sets or memory are made") {
    Still still("tests/19_ambiance/short.film");
    still.check(0.75);
    still.check(2.5);
    still.check(4.25, 4);  // a street by four methods
}

TEST_CASE("in no scene of the course's film is anything uploaded where nothing moves", "[.long]") {
    Still still("films/ambiance.film");
    for (const FilmScene& scene : still.chapter.reel.film().scenes)
        still.check(0.5 * (scene.from_s + scene.to_s), scene.kind == "street" ? 4 : 0);
}

// Each frame after the switch used to load the scene again, which takes 600 ms on an H100.
TEST_CASE("a module that a track switches on in mid-scene was loaded with the others, and once") {
    const auto film = std::filesystem::temp_directory_path() / fmt::format("lightwalk_switched_{}.film", getpid());
    std::ofstream(film) << R"({"duration_s": 4, "scenes": [
        {"name": "sea", "kind": "descent", "scene": "films/descent.json", "from_s": 0, "to_s": 4,
         "knobs": {"water.method": ["steps", [0, "none"], [2, "fft"]]}}]})";
    Still still(film.c_str());
    std::filesystem::remove(film);
    int loads = 0;
    for (const double time_s : {1.0, 1.5, 2.5, 3.0, 3.5, 1.0}) {
        still.draw(time_s);
        for (const PassTime& pass : still.frame.times) loads += pass.name.find("ground errors") != std::string::npos;
    }
    CHECK(loads == 1);
}

TEST_CASE("the worker makes a film's later scenes while the first is drawn, and a time stays the same picture") {
    const auto pictures = [](bool waits) {
        Gpu gpu(DeviceOptions{.validate = true});
        Ambiance chapter;
        chapter.plays = true;
        load_scene(chapter, gpu, "tests/19_ambiance/short.film");
        Frame frame(gpu);
        frame.fly(2);
        std::vector<std::vector<std::byte>> all;
        for (const double time_s : {0.25, 0.5, 1.0, 1.75, 2.5, 3.75, 4.75}) {
            render(chapter, frame, {{64, 36}, static_cast<float>(time_s), 0, {}});
            if (all.empty()) CHECK(chapter.reel.parts().size() < 3);
            if (waits) chapter.reel.wait_until_ready();
            all.push_back(gpu.read_back(frame.output));
        }
        chapter.reel.wait_until_ready();
        CHECK(chapter.reel.parts().size() == 3);
        CHECK(chapter.reel.before_scenes_spent.most_items == 0);  // the second frame would wait for it
        CHECK(gpu.device.validation_message_count() == 0);
        return all;
    };
    CHECK(pictures(true) == pictures(false));
}

TEST_CASE("the same scenes are shown since the last cut, or the end of a cross-fade") {
    Still still("tests/19_ambiance/short.film");  // 0 to 2, 1.5 to 3.5, 3.5 to 5 s
    const Reel& reel = still.chapter.reel;
    CHECK(reel.steady_from_s(1) == 0);
    CHECK(reel.steady_from_s(1.75) == 1.5);
    CHECK(reel.steady_from_s(3) == 2);
    CHECK(reel.steady_from_s(4) == 3.5);
}

TEST_CASE("cameras of an edited film move as was chosen for all of them") {
    Still still("tests/19_ambiance/path_loop.film");
    Reel& reel = still.chapter.reel;
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
