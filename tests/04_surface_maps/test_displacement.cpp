// Displacement maps: the shift in numbers, and the purpose of its limit.
#include <cmath>

#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

// As surface_maps.glsl's [displacement] calls it, for rows that begin with the map's value.
Table shifts(Table inputs) {
    for (Row& row : inputs) row[0] = 0.5 - row[0];
    return run_probe(check_device(),
                     {.include = "04_surface_maps/parallax_offset.glsl",
                      .signature = "vec2 parallax_offset_limited(float depth, vec3 to_eye, vec2 deepest)",
                      .inputs = std::move(inputs)},
                     2);
}

// Number of points along the view that show a texture position already shown by an earlier one, for a swell 0.1
// sin(10 u) / 2 with slopes of at most 0.5. `divide`: without the limit.
int seen_twice(double angle_deg, bool divide) {
    const double sine = std::sin(glm::radians(angle_deg)), cosine = std::cos(glm::radians(angle_deg));
    Table inputs;
    for (int i = 0; i < 1000; ++i)
        inputs.push_back({0.5 + 0.5 * std::sin(10 * 0.001 * i), sine, 0, cosine, 0.1 / (divide ? cosine : 1), 1});
    const Table moved = shifts(inputs);
    int twice = 0;
    double furthest = -1;
    for (size_t i = 0; i < moved.size(); ++i) {
        const double u = 0.001 * double(i) + moved[i][0];
        twice += u < furthest - 1e-5;
        furthest = std::max(furthest, u);
    }
    return twice;
}

}  // namespace

TEST_CASE("the limited shift shows no place twice; divided by z a swell of slope 1/2 does from tan(angle) = 2 on",
          "[04.limited_shift]") {
    for (const double angle : {30.0, 60.0, 70.0, 85.0}) CHECK(seen_twice(angle, false) == 0);
    CHECK(seen_twice(60, true) == 0);
    CHECK(seen_twice(70, true) > 50);
    CHECK(seen_twice(85, true) > 200);
}
