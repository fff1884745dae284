// The cheapest way of a scene that is enough.
#include "../catch.h"
#include "19_ambiance/ambiance.h"
#include "19_ambiance/ways.h"

using namespace lightwalk;

TEST_CASE("the cheapest way within the budget; where none is, the truest, which is said") {
    const std::vector<Way> ways{{.knobs = {}, .error = 0.003, .gpu_ms = 10},
                                {.knobs = {}, .error = 0.004, .gpu_ms = 12},
                                {.knobs = {}, .error = 0.01, .gpu_ms = 5},
                                {.knobs = {}, .error = 0.03, .gpu_ms = 2}};
    CHECK(cheapest_way(ways, 0.003).way.gpu_ms == 10);
    CHECK(cheapest_way(ways, 0.005).way.gpu_ms == 10);  // not the one that is enough and dearer
    CHECK(cheapest_way(ways, 0.01).way.gpu_ms == 5);
    CHECK(cheapest_way(ways, 1.0).way.gpu_ms == 2);
    CHECK(cheapest_way(ways, 1.0).enough);
    CHECK(cheapest_way(ways, 0.001).way.error == 0.003);
    CHECK(!cheapest_way(ways, 0.001).enough);
    const std::vector<Way> rough{{.knobs = {}, .error = 0.3, .gpu_ms = 10}, {.knobs = {}, .error = 0.2, .gpu_ms = 12}};
    CHECK(cheapest_way(rough, 0.1).way.error == 0.2);  // though it stands second, and is dearer
}

TEST_CASE("a way's error counts what it loses between pixels: the most accurate one has some, more samples less") {
    Gpu gpu(DeviceOptions{.validate = true});
    Ambiance chapter;
    Options options;
    options.size = {48, 27};
    load_scene(chapter, gpu, "tests/19_ambiance/short.film");
    const auto best_way = [&] { return measure_ways(chapter, chapter.reel, gpu, 0, options).front(); };
    const double alone = best_way().error;
    chapter.samples.value = 4;
    CHECK(alone > 0.005);
    CHECK(best_way().error < 0.8 * alone);
    CHECK(chapter.samples == 4);
    CHECK(chapter.antialias.method.is("mlaa"));
    CHECK(gpu.device.validation_message_count() == 0);
}
