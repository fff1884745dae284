// Checks of chapter 03: values against double precision, then properties.
#include "03_attenuation/exercises.h"
#include "03_attenuation/truth.h"
#include "common/check/check.h"
#include "common/check/guard.h"

using namespace lightwalk;

namespace {

// Hints for both falloffs.
std::string falloff_hint(std::span<const double> in, std::span<const double> got) {
    if (in[1] == 0) return "a light of range 0 lights nothing: ask that before you divide by the range";
    if (in[0] >= in[1] && got[0] != 0)
        return "beyond the range the bracket is negative, and its square is not: return 0 before";
    if (in[0] == 0) return "at distance 0 nothing is lost: 1";
    return "";
}

// A falloff between 0 and 1 that never rises with the distance and is 0 from the range on.
void check_falloff(Check& check, const Probe& probe, const Row& others) {
    const Table results = check.probe(probe);
    check.property(probe, results, "but a falloff is between 0 and 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1; });
    check.property(probe, results, "but nothing arrives at the range and beyond it",
                   [](auto in, auto out) { return in[0] < in[1] || out[0] == 0; });
    Probe walk = probe;
    walk.inputs.clear();
    for (int i = 0; i <= 200; ++i) {
        walk.inputs.push_back({0.05 * i, 8.0});
        walk.inputs.back().insert(walk.inputs.back().end(), others.begin(), others.end());
    }
    double before = 2;
    check.property(walk, run_probe(check_device(), walk, 1), "more than where it is nearer", [&](auto, auto out) {
        const bool falls = out[0] <= before + 1e-7;
        before = out[0];
        return falls;
    });
}

}  // namespace

CHECK_EXERCISE("03.range_fade", "test first that the distance is below the range; then nothing is divided by 0") {
    Probe probe{
        .include = "03_attenuation/range_fade.glsl",
        .signature = "float range_fade(float distance, float range, float k)",
        .inputs = {{0, 10, 1}, {5, 10, 1}, {5, 10, 0}, {10, 10, 1}, {12, 10, 1}, {0, 0, 1}, {1, 0, 1}, {1, 2, 100}},
        .truth = [](std::span<const double> in) { return Row{truth::range_fade(in[0], in[1], in[2])}; },
        .bound = {.absolute = 1e-6},
        .hint = falloff_hint};
    Random random;
    for (int i = 0; i < 2000; ++i)
        probe.inputs.push_back({random.uniform(0, 12), random.uniform(0, 12), random.logarithmic(0.01, 100)});
    check_falloff(check, probe, {1});
}

CHECK_EXERCISE("03.inverse_square_window",
               "the window is 1 - (distance / range)^4, squared; test first that the distance is below the range") {
    Probe probe{.include = "03_attenuation/inverse_square_window.glsl",
                .signature = "float inverse_square_window(float distance, float range)",
                .inputs = {{0, 10}, {1, 100}, {5, 10}, {7.5, 10}, {9, 10}, {10, 10}, {12, 10}, {0, 0}, {1, 0}},
                .truth = [](std::span<const double> in) { return Row{truth::inverse_square_window(in[0], in[1])}; },
                .bound = {.absolute = 1e-6},
                .hint = falloff_hint};
    Random random;
    for (int i = 0; i < 2000; ++i) probe.inputs.push_back({random.uniform(0, 12), random.uniform(0, 12)});
    check_falloff(check, probe, {});
}

CHECK_EXERCISE("03.spot_cone",
               "t is clamp((cosine - cos_outer) / (cos_inner - cos_outer), 0, 1): what if both are equal?") {
    const double c20 = std::cos(glm::radians(20.0)), c30 = std::cos(glm::radians(30.0));
    Probe probe{.include = "03_attenuation/spot_cone.glsl",
                .signature = "float spot_cone(float cosine, float cos_inner, float cos_outer, float softness)",
                .inputs = {{1, 0.9, 0.8, 0.5},
                           {0.9, 0.9, 0.8, 0},
                           {0.85, 0.9, 0.8, 0},
                           {0.85, 0.9, 0.8, 1},
                           {0.8, 0.9, 0.8, 1},
                           {0.5, 0.9, 0.8, 1},
                           {-1, 0.9, 0.8, 0.5},
                           {0.91, 0.9, 0.9, 0.5},
                           {0.89, 0.9, 0.9, 0.5},
                           {1, c20, c20, 0},
                           {c30, c20, c20, 1},
                           {-0.5, -0.2, -0.8, 0.3},
                           {-0.9, -1, -1, 0.5}},
                .truth = [](std::span<const double> in) { return Row{truth::spot_cone(in[0], in[1], in[2], in[3])}; },
                // The division magnifies the rounding error of a difference of cosines.
                .bound = {.absolute = 2e-4},
                .hint = [](auto in, auto got) -> std::string {
                    if (in[1] == in[2]) return "the angles are equal: a hard edge, with 1 inside and 0 outside";
                    if (in[0] >= in[1])
                        return "inside the inner cone: 1; the inner angle is the smaller, its cosine the larger";
                    if (in[0] <= in[2]) return "outside of the outer cone: 0";
                    const double t = (in[0] - in[2]) / (in[1] - in[2]);
                    if (std::fabs(got[0] - t) < 1e-3) return "t is right; its power mix(1, 0.35, softness) is missing";
                    return "in between t goes from 0 at cos_outer to 1 at cos_inner, in proportion to the cosine";
                }};
    Random random;
    while (probe.inputs.size() < 3000) {
        const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), cosine = random.uniform(-1, 1);
        if (std::fabs(a - b) > 1e-3)
            probe.inputs.push_back({cosine, std::max(a, b), std::min(a, b), random.uniform(0, 1)});
        const double edge = random.uniform(-1, 1);  // equal angles: a hard edge
        if (std::fabs(cosine - edge) > 1e-3) probe.inputs.push_back({cosine, edge, edge, random.uniform(0, 1)});
    }
    const Table results = check.probe(probe);
    // Upon a hard edge, which is at both angles, it is one or the other.
    Probe edge = probe;
    edge.inputs = {{0.9, 0.9, 0.9, 0}, {0.9, 0.9, 0.9, 1}, {1, 1, 1, 0.5}, {-1, -1, -1, 0.5}, {0, 0, 0, 0.5}};
    edge.truth = [](std::span<const double>) { return Row{0.5}; };
    edge.bound = {.absolute = 0.5};
    check.property(edge, check.probe(edge), "but a hard edge is 0 or 1",
                   [](auto, auto out) { return out[0] == 0 || out[0] == 1; });
    check.property(probe, results, "but it must be between 0 and 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1; });
    Probe softer = probe;
    softer.inputs.clear();
    for (int i = 0; i <= 100; ++i) softer.inputs.push_back({0.85, 0.9, 0.8, 0.01 * i});
    double before = 0;
    check.property(softer, run_probe(check_device(), softer, 1), "less than where softness is lower",
                   [&](auto, auto out) {
                       const bool rises = out[0] >= before - 1e-6;
                       before = out[0];
                       return rises;
                   });
}

namespace {

std::string words(const Light& light, double radius_m, const Bounds& box) {
    const auto vector = [](const glm::vec3& v) {
        return "(" + number_text(static_cast<double>(v.x)) + ", " + number_text(static_cast<double>(v.y)) + ", " +
               number_text(static_cast<double>(v.z)) + ")";
    };
    std::string text = light.kind == Light::Kind::spot ? "a spot light at " : "a point light at ";
    text += vector(light.position) + " of radius " + number_text(radius_m) + " m";
    if (light.kind == Light::Kind::spot)
        text += ", towards " + vector(light.direction) + ", half angle " +
                number_text(glm::degrees(static_cast<double>(light.outer_rad))) + " degrees";
    return text + ", and the box from " + vector(box.lower) + " to " + vector(box.upper);
}

void expect_reach(Check& check, const Light& light, double radius_m, const Bounds& box) {
    const double miss = truth::misses_box_by(light, radius_m, box), slack = 1e-3 * radius_m;
    const std::string call = words(light, radius_m, box);
    guard_call("light_reaches_box for " + call);
    const bool reaches = light_reaches_box(light, static_cast<float>(radius_m), box);
    guard_call("");
    if (miss < -slack) check.expect(reaches, call + " gave false: light is lost");
    if (miss > 2 * slack) check.expect(!reaches, call + " gave true: the box is out of its reach");
}

}  // namespace

CHECK_EXERCISE(
    "03.light_reaches_box",
    "clamp the light's position to the box; then compare the cone's side with the bounding sphere of the box") {
    const Bounds unit{glm::vec3(-1.0f), glm::vec3(1.0f)};
    Light sun, lamp{.kind = Light::Kind::point}, spot{.kind = Light::Kind::spot};
    check.expect(light_reaches_box(sun, 0.0f, unit), "a directional light gave false: it reaches everything");
    check.expect(!light_reaches_box(lamp, 0.0f, unit), "a radius of 0 gave true: such a light lights nothing");
    for (const float x : {0.0f, 0.5f, 1.5f, 2.5f, 4.0f}) {
        lamp.position = spot.position = {x, 0.0f, 0.0f};
        expect_reach(check, lamp, 2.0, unit);
        for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0)})
            for (const float degrees : {0.0f, 10.0f, 60.0f, 90.0f, 120.0f, 180.0f}) {
                spot.direction = direction;
                spot.outer_rad = glm::radians(degrees);
                expect_reach(check, spot, 20.0, unit);
            }
    }
    Random random;
    for (int i = 0; i < 20000; ++i) {
        Bounds box;
        for (int corner = 0; corner < 2; ++corner)
            box.add(glm::vec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)));
        Light light{.kind = i % 2 ? Light::Kind::point : Light::Kind::spot, .direction = random.direction()};
        light.position = glm::vec3(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8));
        light.outer_rad = static_cast<float>(random.uniform(0, 3.1));
        expect_reach(check, light, random.logarithmic(0.1, 10), box);
    }
}
