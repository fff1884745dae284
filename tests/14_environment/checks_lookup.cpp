// Checks of the exercises about directions: values against double precision.
#include <fmt/core.h>

#include "14_environment/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row row_of(glm::dvec3 v) { return {v.x, v.y, v.z}; }

}  // namespace

CHECK_EXERCISE("14.direction_to_equirect",
               "u is 1/2 + atan(x, -z) / (2 pi), v is the angle from +y over pi; ask before atan(0.0, 0.0)") {
    Probe probe{.include = "14_environment/direction_to_equirect.glsl",
                .signature = "vec2 direction_to_equirect(vec3 direction)",
                .inputs = {{0, 0, -1},
                           {1, 0, 0},
                           {-1, 0, 0},
                           {1e-3, 0, 1},
                           {-1e-3, 0, 1},
                           {0, 1, -1},
                           {0, 0, 1},
                           {0, 3, 4},
                           {0, -1, 1e-4},
                           {3, 4, 5},
                           {0, 1e3, -0.1},
                           {0, -7, -7},
                           {1e-3, 1e-3, 0}},
                .truth =
                    [](auto in) {
                        const glm::dvec2 uv = truth::equirect(vector3(in));
                        return Row{uv.x, uv.y};
                    },
                // acos of a component has lost half of its digits near the poles.
                .bound = {.absolute = 2e-4},
                // The left and the right edge are one line.
                .grants =
                    [](auto in, auto out) {
                        return in[0] == 0 && in[2] > 0 && std::fabs(out[1] - truth::equirect(vector3(in)).y) <= 2e-4 &&
                               (std::fabs(out[0]) <= 2e-4 || std::fabs(out[0] - 1) <= 2e-4);
                    },
                .hint = [](auto in, auto out) -> std::string {
                    const glm::dvec2 uv = truth::equirect(vector3(in));
                    if (std::fabs(out[0] - uv.x) < 1e-3 && std::fabs(out[1] - (1 - uv.y)) < 1e-3)
                        return "v is 0 at the upper edge, which is +y";
                    if (std::fabs(out[1] - uv.y) < 1e-3 && std::fabs(out[0] - (1 - uv.x)) < 1e-3)
                        return "to the right of the middle lies +x";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 d = random.direction() * static_cast<float>(random.logarithmic(0.01, 100));
        if (std::hypot(d.x, d.z) > 0.02 * std::fabs(d.y) && !(d.z > 0 && std::fabs(d.x) < 1e-3 * d.z))
            probe.inputs.push_back({d.x, d.y, d.z});
    }
    check.probe(probe);

    Probe poles = probe;
    poles.inputs = {{0, 1, 0}, {0, -1, 0}, {0, 20, 0}, {0, -0.01, 0}};
    poles.truth = [](auto in) { return Row{0.5, in[1] > 0 ? 0.0 : 1.0}; };
    poles.hint = nullptr;
    check.probe(poles);
}

CHECK_EXERCISE(
    "14.importance_sample_ggx",
    "cos² theta = (1 - r) / (1 + (alpha² - 1) r), phi = 2 pi random.x; then (sin cos phi, sin sin phi, cos)") {
    Probe probe{.include = "14_environment/importance_sample_ggx.glsl",
                .signature = "vec3 importance_sample_ggx(vec2 random, float alpha)",
                .inputs = {{0, 0, 0.5}, {0, 0, 0}, {0.25, 0.5, 0}, {0.7, 0.9999, 0}, {0.5, 0.9999, 1}, {0.25, 0.25, 1}},
                .truth =
                    [](auto in) {
                        const double a = in[2] * in[2], phi = truth::around * in[0];
                        // 1 - c in a form that keeps its digits near the normal.
                        const double sine2 = a * in[1] / (1 + (a - 1) * in[1]), s = std::sqrt(sine2);
                        return Row{s * std::cos(phi), s * std::sin(phi), std::sqrt(1 - sine2)};
                    },
                // Near the normal 1 - cos² has half of a float's digits.
                .bound = {.absolute = 6e-4},
                .hint = [](auto in, auto out) -> std::string {
                    const double length = glm::length(vector3(out));
                    if (std::isfinite(length) && std::fabs(length - 1) > 1e-3)
                        return fmt::format("its length is {:.3g}; sin² = 1 - cos²", length);
                    const double a = in[2], c2 = (1 - in[1]) / (1 + (a - 1) * in[1]);
                    if (in[2] > 0 && in[2] < 1 && std::fabs(out[2] - std::sqrt(c2)) < 1e-3)
                        return "D has alpha squared";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 400; ++i)
        probe.inputs.push_back({random.uniform(0, 0.999), random.uniform(0, 0.999), random.uniform(0.02, 1)});
    check.probe(probe);
}

namespace {

// The mistakes that are told by name, and none.
enum class Slip { none, no_center, no_position, unprojected, farthest, behind, clamped, zero_left };

glm::dvec3 projected(std::span<const double> in, Slip slip = Slip::none) {
    glm::dvec3 p = vector3(in);
    const glm::dvec3 d = vector3(in.subspan(3)), lower = vector3(in.subspan(6)), upper = vector3(in.subspan(9));
    const glm::dvec3 center = slip == Slip::no_center ? glm::dvec3(0) : vector3(in.subspan(12));
    if (slip == Slip::unprojected) return d;
    if (slip == Slip::clamped) p = glm::clamp(p, lower, upper);
    double t = slip == Slip::farthest ? 0 : 1e300;
    for (int a = 0; a < 3; ++a) {
        if (d[a] == 0) continue;
        const double here = ((d[a] > 0 ? upper[a] : lower[a]) - p[a]) / d[a];
        t = slip == Slip::farthest ? std::max(t, here) : std::min(t, here);
    }
    if (slip != Slip::behind) t = std::max(t, 0.0);
    const glm::dvec3 point = slip == Slip::no_position ? t * d : p + t * d - center;
    return point == glm::dvec3(0) && slip != Slip::zero_left ? d : point;
}

const std::pair<Slip, const char*> slips[] = {
    {Slip::unprojected, "the ray begins at position, and the cube was drawn from center: the directions differ"},
    {Slip::no_position, "that is the way from position to the wall: the cube is looked up from center"},
    {Slip::no_center, "that is the way to the wall from the origin: the cube is looked up from center"},
    {Slip::farthest, "the ray meets the nearest of the three walls that it goes towards"},
    {Slip::behind, "outside the box, and the ray leads away: the point is position, not one behind it"},
    {Slip::clamped,
     "outside the box, and the ray leads away: the point is position as it is, not its nearest in the box"},
    {Slip::zero_left, "the point is center itself, which is no direction: return the ray's"}};

}  // namespace

CHECK_EXERCISE("14.box_project",
               "for each axis the wall that the ray goes towards; the nearest of the three; from the center to there") {
    // A ray that meets a wall at once has no direction of its own; the lengths of results are free.
    const auto unit = [](glm::dvec3 v) { return v / glm::length(v); };
    Probe probe{.include = "14_environment/box_project.glsl",
                .signature = "vec3 box_project(vec3 position, vec3 direction, vec3 lower, vec3 upper, vec3 center)",
                .truth = [unit](auto in) { return row_of(unit(projected(in))); }};
    const auto add = [&](glm::dvec3 p, glm::dvec3 d, glm::dvec3 lower, glm::dvec3 upper, glm::dvec3 center) {
        Row row;
        for (const glm::dvec3 v : {p, d, lower, upper, center}) append(row, v);
        probe.inputs.push_back(row);
    };
    const glm::dvec3 low(-1, -2, -3), high(3, 2, 1);
    add({0.5, 0.25, -0.5}, {1, 2, 0.5}, low, high, {1, -1, 0});  // a plain one, of three walls
    for (const glm::dvec3 d : {glm::dvec3(1, 0, 0),
                               {0, 1, 0},
                               {0, 0, 1},
                               {-1, 0, 0},
                               {0, -1, 0},
                               {0, 0, -1},
                               {1, 1, 0},
                               {0, -2, 2},
                               {-0.5, 0, 0.25}}) {
        add({0.5, 0.25, -0.5}, d, low, high, {0, 0, 0});
        add({0, 0, 0}, d, low, high, {0, 0, 0});
    }
    // Outside, away from the box: beyond a wall of each axis, and beyond two.
    const glm::dvec3 center(0.5, -0.5, 0.25);
    add({4, 1, 0.5}, {1, 0.25, 0}, low, high, center);
    add({-1.5, 1, 0.5}, {-1, 0.25, 0.5}, low, high, center);
    add({1, 2.25, 0.5}, {0.5, 1, 0.25}, low, high, center);
    add({1, -2.5, 0.5}, {0.5, -0.5, 0}, low, high, center);
    add({1, 1, 1.5}, {0, 0.25, 2}, low, high, center);
    add({1, 1, -3.25}, {0.5, 0.25, -1}, low, high, center);
    add({4, 1, 2}, {1, -1, 0.5}, low, high, center);
    add({4, 0, 0}, {1, 0.25, 0}, low, high, {0, 0, 0});
    // The point is the cube's own middle: at once, along the way, and outside.
    add({3, 0, 0}, {1, 0, 0.5}, low, high, {3, 0, 0});
    add({0, 0.5, 0}, {2, 0, 0}, low, high, {3, 0.5, 0});
    add({4, 0, 0}, {1, 0.25, 0}, low, high, {4, 0, 0});
    Random random;
    for (int i = 0; i < 300; ++i) {
        glm::dvec3 p, middle, lower, upper;
        for (int a = 0; a < 3; ++a) {
            lower[a] = i % 2 ? low[a] : random.uniform(-20, 0);
            upper[a] = i % 2 ? high[a] : random.uniform(1, 20);
            const double side = upper[a] - lower[a];
            p[a] = lower[a] + random.uniform(0.05, 0.95) * side;
            middle[a] = lower[a] + random.uniform(0.1, 0.9) * side;
        }
        add(p, glm::dvec3(random.direction()) * random.logarithmic(1e-5, 1e4), lower, upper, middle);
        if (i % 3) continue;
        // Outside, and through the box: a rounding beyond a wall, or far beyond it.
        glm::dvec3 outside = p;
        const int a = i / 3 % 3;
        outside[a] = upper[a] + random.logarithmic(1e-4, 10);
        add(outside, p - outside, lower, upper, middle);
    }
    // Any length is right: compared as directions.
    const Table got = run_probe(check_device(), probe, 3);
    for (size_t i = 0; i < got.size(); ++i) {
        const Row& in = probe.inputs[i];
        const glm::dvec3 g = vector3(got[i]), want = unit(projected(in));
        const double length = glm::length(g);
        const bool is_direction = std::isfinite(length) && length > 0;
        const bool right = is_direction && glm::length(unit(g) - want) < 1e-4;
        std::string hint;
        for (const auto& [slip, words] : slips) {
            const glm::dvec3 other = projected(in, slip);
            const bool fits = slip == Slip::zero_left ? g == other : glm::length(unit(g) - unit(other)) < 1e-5;
            if (hint.empty() && glm::length(unit(other) - want) > 1e-4 && fits) hint = words;
            if (hint.empty() && slip == Slip::zero_left && length == 0) hint = words;
        }
        if (hint.empty() && (in[3] == 0 || in[4] == 0 || in[5] == 0))
            hint = "a component of the direction is 0: the ray meets neither wall across that axis, leave it out";
        check.expect(right, wrong_text(probe, i, got[i]) + " or another length", hint);
        if (!right) return;
    }
    // Undefined operations, such as a division by 0, are found by the probe itself.
    probe.truth = [got, inputs = probe.inputs](auto in) -> Row {
        for (size_t i = 0; i < inputs.size(); ++i)
            if (std::equal(in.begin(), in.end(), inputs[i].begin())) return got[i];
        return {0, 0, 0};
    };
    probe.bound = {.absolute = 1e-4, .relative = 1e-4};
    check.probe(probe);
}
