// Checks of the exercises about lamps that have a size.
#include "04_surface_maps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(const glm::dvec3& v) {
    Row row;
    append(row, v);
    return row;
}

}  // namespace

CHECK_EXERCISE("04.above_horizon", "an end above the horizon stays; one below it moves along the edge to z = 0") {
    Probe probe{
        .include = "04_surface_maps/above_horizon.glsl",
        .signature = "vec3 above_horizon(vec3 end, vec3 other)",
        .inputs = {{1, 0, 1, 2, 0, 1},
                   {1, 0, 1, 2, 0, -3},
                   {1, 0, -1, 1, 0, 1},
                   {0, 4, -1, 4, 4, 3},
                   {0, 4, -3, 4, 4, 1},
                   {2, 5, 0, 4, 7, 1},
                   {2, 5, -1e-4, 4, 7, 1},
                   {3, 0, -50, 1, 0, 0.5}},
        .truth =
            [](std::span<const double> in) { return row_of(truth::above_horizon(vector3(in, 0), vector3(in, 3))); },
        .bound = {.absolute = 1e-5, .relative = 1e-5},
        .hint = [](auto in, auto got) -> std::string {
            if (in[2] > 0) return "this end is above the horizon: it stays";
            if (got[2] != 0) return "the crossing lies on the horizon: its z is 0";
            return "the nearer the end is to the horizon, the nearer the crossing is to the end";
        }};
    Random random;
    for (int i = 0; i < 2000; ++i) {
        Row row;
        for (int c = 0; c < 6; ++c) row.push_back(random.uniform(-4, 4));
        if (row[2] <= 0 && row[5] <= 0.01) row[5] = random.uniform(0.01, 4);
        probe.inputs.push_back(row);
    }
    const Table results = check.probe(probe);
    check.property(probe, results, "but the crossing has a z of exactly 0, which rounding does not give",
                   [](auto in, auto got) { return in[2] > 0 || got[2] == 0; });
}

CHECK_EXERCISE("04.nearest_on_lamp", "the point of a ball that is nearest to a ray, from the ray's beginning on") {
    Probe probe{.include = "04_surface_maps/nearest_on_lamp.glsl",
                .signature = "vec3 nearest_on_lamp(vec3 middle, float radius, vec3 mirrored)",
                .inputs = {{0, 0, 2, 0.5, 1, 0, 0},
                           {0, 0, 2, 0.5, 0, 0, 1},
                           {0.3, 0, 2, 0.5, 0, 0, 1},
                           {1, 0, 2, 0.5, 0, 0, 1},
                           {1, 0, -2, 0.5, 0, 0, 1},
                           {0, 0, -2, 1, 0, 0, 1},
                           {0, 1, 1, 0, 0, 0, 1}},
                .truth =
                    [](std::span<const double> in) {
                        return row_of(truth::nearest_on_lamp(vector3(in, 0), in[3], vector3(in, 4)));
                    },
                .bound = {.absolute = 1e-4, .relative = 1e-4},
                .hint = [](auto in, auto got) -> std::string {
                    const glm::dvec3 middle = vector3(in, 0);
                    if (glm::dot(middle, vector3(in, 4)) < 0)
                        return "the lamp is behind this ray, which begins at the origin";
                    if (glm::length(vector3(got, 0) - middle) > in[3] + 1e-3)
                        return "this point is outside of the lamp";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 middle = random.uniform(0.5, 5) * glm::dvec3(random.direction());
        Row row = row_of(middle);
        row.push_back(random.uniform(0, 0.95) * glm::length(middle));
        append(row, random.direction());
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
