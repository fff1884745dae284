// The cheapest way of a scene that is enough.
#include "../catch.h"
#include "19_ambiance/ways.h"

using namespace lightwalk;

TEST_CASE("the cheapest way within the budget; where none is, the most accurate one") {
    const std::vector<Way> ways{{.knobs = {}, .error = 0, .gpu_ms = 10},
                                {.knobs = {}, .error = 0.004, .gpu_ms = 12},
                                {.knobs = {}, .error = 0.01, .gpu_ms = 5},
                                {.knobs = {}, .error = 0.03, .gpu_ms = 2}};
    CHECK(cheapest_way(ways, 0.0).gpu_ms == 10);
    CHECK(cheapest_way(ways, 0.005).gpu_ms == 10);  // not the one that is enough and dearer
    CHECK(cheapest_way(ways, 0.01).gpu_ms == 5);
    CHECK(cheapest_way(ways, 1.0).gpu_ms == 2);
}
