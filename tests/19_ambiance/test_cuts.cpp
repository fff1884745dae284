// Cuts of a film that plays: a scene's first frames find made what they need.
#include "../catch.h"
#include "19_ambiance/ambiance.h"
#include "19_ambiance/benchmark.h"
#include "common/app/render.h"
#include "common/gpu/gpu_work.h"

using namespace lightwalk;

namespace {

bool is_after_cut(const Timeline& film, int number) {
    return std::ranges::any_of(film.scenes, [&](const FilmScene& scene) {
        const double frames = number - 60 * scene.from_s;
        return scene.from_s > 0 && frames >= 0 && frames < 6;
    });
}

void check_cuts(const char* film, const std::vector<int>& numbers, bool with_memory) {
    Gpu gpu(DeviceOptions{.validate = true});
    Ambiance chapter;
    chapter.plays = true;
    load_scene(chapter, gpu, film);
    Frame frame(gpu);
    const auto draw = [&](int number) {
        render(chapter, frame, {{96, 54}, static_cast<float>(number) / 60.0f, 0, {}});
    };
    draw(0);
    chapter.reel.wait_until_ready();
    draw(0);
    for (const int number : numbers) {
        const GpuWork before = gpu_work;
        draw(number);
        INFO("at " << number / 60.0 << " s");
        CHECK(gpu_work.pipelines == before.pipelines);
        CHECK(gpu_work.transfers == before.transfers);
        if (with_memory && is_after_cut(chapter.reel.film(), number)) CHECK(gpu_work.allocations == before.allocations);
    }
    CHECK(gpu.device.validation_message_count() == 0);
}

}  // namespace

TEST_CASE("the frames of a small film build no pipeline and wait for no transfer, and at a cut allocate no memory") {
    std::vector<int> numbers;
    for (int i = 1; i < 60; ++i) numbers.push_back(5 * i);
    for (const int cut : {90, 210})
        for (int i = 0; i < 6; ++i) numbers.push_back(cut + i);
    std::ranges::sort(numbers);
    check_cuts("tests/19_ambiance/short.film", numbers, true);
}

TEST_CASE("the frames of the course's film build no pipeline and wait for no transfer", "[.long]") {
    std::vector<int> numbers = played_numbers(read_timeline(find_asset("films/ambiance.film")), 12);
    check_cuts("films/ambiance.film", numbers, false);
}

TEST_CASE("a scene is ready once the worker has made it: the benchmark stands still before") {
    Gpu gpu(DeviceOptions{.validate = true});
    Ambiance chapter;
    chapter.plays = true, chapter.reel.ahead_s.value = 0;
    load_scene(chapter, gpu, "tests/19_ambiance/short.film");
    Frame frame(gpu);
    const auto draw = [&] { render(chapter, frame, {{96, 54}, 0.0f, 0, {}}); };
    draw();
    CHECK(chapter.reel.is_ready(0.5));
    CHECK_FALSE(chapter.reel.is_ready(1.75));  // a cross-fade
    CHECK_FALSE(chapter.reel.is_ready(3));
    chapter.reel.ahead_s.value = 2;
    draw();
    chapter.reel.wait_until_ready();
    CHECK(chapter.reel.is_ready(1.75));
    CHECK(chapter.reel.is_ready(3));
    CHECK_FALSE(chapter.reel.is_ready(4));
}
