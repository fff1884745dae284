// Checks of the exercises about microfacets, and about lamps that have a size.
#include <glm/gtc/constants.hpp>

#include "04_surface_maps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(const glm::dvec3& v) {
    Row row;
    append(row, v);
    return row;
}

// The area of the mirrors that face a direction at this cosine, each at its slant, per area of the surface. D, weighted with the
// mirror's own cosine, has t² / (t² + alpha²) of its area below the slope t: the sum is over equal parts of it, and in each over
// the turns at which the mirrors face the direction.
double facing(double cosine, double alpha) {
    const double pi = glm::pi<double>(), sine = std::sqrt(1 - cosine * cosine);
    const int parts = 400;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double rest = 1 - (i + 0.5) / parts;  // squared, the area that is steeper; finer where slopes are large
        const double sideways = sine * alpha * std::sqrt(1 - rest * rest) / rest;
        const double turn = sideways > cosine ? std::acos(-cosine / sideways) : pi;
        sum += 2 * rest * (cosine * turn + sideways * std::sin(turn)) / pi;
    }
    return sum / parts;
}

}  // namespace

// What is seen of the mirrors covers the surface, seen at its slant, once: c = facing(c) / (1 + Λ(c)). So the truth needs no
// formula but D's.
CHECK_EXERCISE("04.ggx_visibility",
               "insert both Λ into G, and multiply with 4 (N·L) (N·V) what stands below the line") {
    Probe probe{
        .include = "04_surface_maps/ggx_visibility.glsl",
        .signature = "float ggx_visibility(float n_dot_l, float n_dot_v, float alpha)",
        .inputs = {{1, 1, 0.5},
                   {1, 1, 1},
                   {0.5, 1, 1},
                   {0.5, 0.5, 0.25},
                   {0.25, 0.75, 0.015625},
                   {0, 1, 0.5},
                   {0.5, 0, 1},
                   {1e-3, 1e-3, 0.1}},
        .truth =
            [](auto in) {
                const double below = in[1] * facing(in[0], in[2]) + in[0] * facing(in[1], in[2]) - in[0] * in[1];
                return Row{0.25 / below};
            },
        .bound = {.relative = 1e-3},
        .hint = [](auto in, auto got) -> std::string {
            const auto near = [&](double other) { return std::fabs(got[0] / other - 1) < 1e-3; };
            const double l = in[0], v = in[1];
            const auto below = [&](double alpha) { return v * facing(l, alpha) + l * facing(v, alpha) - l * v; };
            if (l == 0 || v == 0) return "multiplied out, the cosines cancel: nothing divides by one of them";
            if (near(0.25 / (facing(l, in[2]) * facing(v, in[2]))))
                return "the product of two shares loses deep mirrors twice: add the two Λ instead";
            if (near(1 / below(in[2])) || near(l * v / below(in[2])))
                return "that is 4 V, or G: V has the whole of 4 (N·L) (N·V) below it";
            if (near(0.25 / below(std::sqrt(in[2]))))
                return "Λ has the square of alpha, which is no roughness any more";
            return "";
        }};
    Random random;
    for (int i = 0; i < 200; ++i)
        probe.inputs.push_back({random.uniform(0.001, 1), random.uniform(0.001, 1), random.logarithmic(1.0 / 64, 1)});
    check.probe(probe);

    // A white metal of alpha 1, seen from the front, gives back 1 - ln 2: the integral of D V (N·L), where D is 1 / pi.
    probe.inputs.clear();
    const int lights = 100;
    for (int i = 0; i < lights; ++i) probe.inputs.push_back({(i + 0.5) / lights, 1, 1});
    double back = 0;
    size_t at = 0;
    for (const Row& got : check.probe(probe)) back += 2 * got[0] * probe.inputs[at++][0] / lights;
    check.expect(std::fabs(back - (1 - std::log(2.0))) < 1e-4,
                 fmt::format("a white metal of alpha 1 gives back {:.4f} of the light, and not 1 - ln 2", back));
}

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
