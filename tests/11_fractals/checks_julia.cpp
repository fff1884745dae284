// Checks of chapter 11's Julia sets: values against double precision, then properties.
#include <fmt/core.h>

#include <bit>

#include "11_fractals/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

glm::dvec4 four(std::span<const double> in) { return {in[0], in[1], in[2], in[3]}; }

Row row_of(glm::dvec4 v) { return {v.x, v.y, v.z, v.w}; }

/// An integer of a struct's: the probe reads all its members as floats.
int whole(double x) { return std::bit_cast<int32_t>(static_cast<float>(x)); }

/// Middles along the ray, how far beside it, radii: of three balls.
struct Balls {
    const char* name;
    double ball[3][3];
    double distance_at(double t) const {
        double nearest = 1e9;
        for (const auto& b : ball)
            if (b[2] > 0) nearest = std::min(nearest, std::hypot(t - b[0], b[1]) - b[2]);
        return std::max(nearest, 0.0);
    }
    /// Where the distance first falls to epsilon + slope t, or -1.
    double hit(double start, double end, double epsilon, double slope) const {
        for (double t = start; t < end; t += 1e-4)
            if (distance_at(t) <= epsilon + slope * t) return t;
        return -1;
    }
    struct Walk {
        double t, distance;  ///< of the last place that was asked
        int steps, ended;
        double doubt;  ///< how near a comparison was to going the other way
    };
    /// Queries of a march by whole distances.
    Walk walk(double t, double end, double epsilon, double slope, int most) const {
        Walk walk{.t = t, .distance = 0, .steps = 0, .ended = 2, .doubt = 1};
        while (walk.steps < most && walk.ended == 2) {
            walk.t = t;
            walk.distance = distance_at(t);
            ++walk.steps;
            const double above = walk.distance - epsilon - slope * t, beyond = t + walk.distance - end;
            walk.doubt = std::min({walk.doubt, std::fabs(above), above > 0 ? std::fabs(beyond) : 1});
            walk.ended = above <= 0 ? 1 : beyond >= 0 ? 0 : 2;
            t += walk.distance;
        }
        return walk;
    }
    std::string glsl() const {
        std::string text;
        for (const auto& b : ball)
            text += fmt::format("{}vec3({:.6f}, {:.6f}, {:.6f})", text.empty() ? "" : ", ", b[0], b[1], b[2]);
        // The macro stands within vec3(...) of the first.
        return text.substr(5, text.size() - 6);
    }
};

}  // namespace

CHECK_EXERCISE("11.quaternion_square", "With q = x + v, q q = x x + 2 x v + v v, and v v = -dot(v, v).") {
    Probe probe{.include = "11_fractals/quaternion_square.glsl",
                .signature = "vec4 quaternion_square(vec4 q)",
                .inputs = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}, {1, 1, 1, 1}},
                .truth = [](auto in) { return row_of(truth::product(four(in), four(in))); },
                .bound = {.absolute = 1e-5, .relative = 2e-6},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[0] == 0 && out[0] >= 0 && std::fabs(in[1]) + std::fabs(in[2]) + std::fabs(in[3]) == 1)
                        return "i i, j j and k k are -1.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i)
        probe.inputs.push_back(
            {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
    check.probe(probe);
}

CHECK_EXERCISE(
    "11.julia_distance",
    "Update |z'| before z; the two ways out of the loop are different cases; test for escape before the logarithm.") {
    Probe probe{
        .include = "11_fractals/julia_distance.glsl",
        .signature = "float julia_distance(vec4 z, vec4 c, int iterations, float escape)",
        .truth = [](auto in) { return Row{truth::julia_distance(four(in), four(in.subspan(4)), int(in[8]), in[9])}; },
        .hint = [](auto in, auto out) -> std::string {
            if (!std::isfinite(out[0]) && four(in) == glm::dvec4(0)) return "|z'| is 0 and must not be divided by.";
            if (!std::isfinite(out[0])) return "|z'|² is above 1e30: return 0.";
            if (out[0] < 0)
                return "The point has not escaped: |z| is below `escape`, and its logarithm may be below 0.";
            if (glm::length(four(in)) > in[9]) return "The point had escaped before the first iteration.";
            return "";
        }};
    const auto add = [&](glm::dvec4 z, glm::dvec4 c, int iterations, double escape) {
        Row row = row_of(z);
        for (const double x : row_of(c)) row.push_back(x);
        row.push_back(iterations);
        row.push_back(escape);
        probe.inputs.push_back(row);
    };
    const glm::dvec4 two(-2, 0, 0, 0), dust(float(0.4), float(0.2), 0, 0), none(0);
    add({0, 0, 0, 0}, none, 10, 8);
    add({0, 0, 0, 0}, dust, 40, 8);
    add({0, 0, 0, 0}, {5, 0, 0, 0}, 10, 4);
    add({2, 0, 0, 0}, two, 200, 8);
    add({-2, 0, 0, 0}, two, 40, 4);
    add({0.5, 0, 0, 0}, none, 40, 8);
    add({0.5, 0.5, 0, 0}, none, 3, 8);
    add({9, 0, 0, 0}, none, 40, 8);
    add({0, 3, 0, 0}, none, 1, 2);
    add({1.5, 0, 0, 0}, none, 1, 2);
    add({1.5, 0, 0, 0}, none, 1, 4);
    add({1.5, 0, 0, 0}, none, 1, 8);
    add({0, 0, 0, 1.25}, none, 60, 64);
    probe.bound = {.absolute = 1e-6, .relative = 2e-4};
    Random random;
    for (int i = 0; i < 600; ++i) {
        const glm::dvec4 c(random.uniform(-0.6, 0.3), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
                           random.uniform(-0.5, 0.5));
        const glm::dvec4 z(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1));
        // Where floats and doubles leave the loop in different turns, or lose the orbit, there is no one answer.
        const double near = truth::julia_distance(z, c, 30, 4);
        if (near > 0.02) {
            add(z, c, 30, 4);
            add(z, c, 30, 16);
        }
    }
    // Rounding may move the turn of the escape: then both values are near each other, but not equal.
    std::erase_if(probe.inputs, [](const Row& row) {
        const double there = truth::julia_distance(four(row), {row[4], row[5], row[6], row[7]}, int(row[8]), row[9]);
        for (const double shift : {1 - 1e-5, 1 + 1e-5})
            if (std::fabs(
                    truth::julia_distance(four(row), {row[4], row[5], row[6], row[7]}, int(row[8]), row[9] * shift) -
                    there) > 1e-12)
                return true;
        return false;
    });
    check.probe(probe);
}

CHECK_EXERCISE("11.march", "Remember the distance at the previous point and the length of the step from it.") {
    const Balls scenes[] = {{"a ball in the way", {{5, 0.3, 1}, {9, 0, 1}, {0, 0, 0}}},
                            {"a ball beside the way", {{4, 1.2, 1}, {9, 2, 0.5}, {0, 0, 0}}},
                            {"a thin ball in the way", {{3, 1.4, 1}, {5.3, 0, 0.1}, {8, 0, 1}}},
                            {"a grain close behind an edge", {{2, 1.05, 1}, {3.1, 0, 0.02}, {9.95, 0, 0.05}}},
                            {"a grain at the end", {{4, 3, 1}, {9.94, 0, 0.04}, {0, 0, 0}}},
                            {"nothing", {{50, 30, 1}, {0, 0, 0}, {0, 0, 0}}}};
    for (const Balls& balls : scenes) {
        Probe probe{
            .include = "../tests/11_fractals/march_counted.glsl",
            .signature =
                "CheckMarchCounted check_march_counted(float start, float end, float epsilon, float slope, float "
                "relaxation, int most)",
            .truth =
                [](auto) {
                    return Row{0, 0, 0, 0, 0};
                },
            .bound = {.absolute = 1e30},
            .macros = {{"BALLS", balls.glsl()}}};
        for (const double relaxation : {1.0, 1.2, 1.5, 1.8, 2.0})
            for (const double start : {0.0, 0.35, 0.7})
                for (const double slope : {0.0, 0.004})
                    probe.inputs.push_back({start, 10, 0.001, slope, relaxation, 400});
        for (const int most : {1, 2, 5, 400})
            for (const double slope : {0.0, double(0.05f)})
                for (const double start : {0.0, 0.7}) probe.inputs.push_back({start, 10, 1e-6, slope, 1, double(most)});
        const Table results = check.probe(probe);
        if (results.empty()) return;
        for (size_t i = 0; i < results.size(); ++i) {
            const Row& in = probe.inputs[i];
            const double right = balls.hit(in[0], in[1], in[2], in[3]), t = results[i][0];
            const int steps = whole(results[i][1]), ended = whole(results[i][2]), asked = whole(results[i][3]);
            const std::string what = fmt::format(
                "march(start = {}, end = {}, epsilon = {}, slope = {}, relaxation = {}, "
                "most = {}) towards {}",
                in[0], in[1], in[2], in[3], in[4], in[5], balls.name);
            const char* names[] = {"MARCH_MISS", "MARCH_HIT", "MARCH_CAPPED"};
            const auto said = [&] {
                return fmt::format("{} ended with {} at t = {:.4f} after {} distances", what,
                                   ended >= 0 && ended < 3 ? names[ended] : "a number that is no end", t, steps);
            };
            check.expect(steps == asked, said() + fmt::format("; it asked for {}", asked),
                         "`steps` is how often distance_at() was called, those of a leap that was taken back too");
            check.expect(
                results[i][4] < 1e-3,
                said() + fmt::format(": after a leap over a gap it went on {:.4f} m from where the step without "
                                     "relaxation would have led",
                                     results[i][4]),
                "back by the whole leap, and on by the distance at the point before");
            if (in[4] == 1) {
                const Balls::Walk walk = balls.walk(in[0], in[1], in[2], in[3], int(in[5]));
                if (walk.doubt > 1e-4) {
                    // A step over a gap of rounding's size may be taken back: one distance more, and less to go with.
                    const bool capped_late = ended == 2 && walk.ended == 1 && walk.steps == int(in[5]);
                    check.expect(ended == walk.ended || capped_late,
                                 said() + fmt::format(", expected {} after {}", names[walk.ended], walk.steps),
                                 walk.ended == 2
                                     ? "A ray that was stopped on its way has neither hit nor missed: MARCH_CAPPED."
                                     : "");
                    check.expect(steps == walk.steps || steps == walk.steps + 1,
                                 said() + fmt::format(", expected {}", walk.steps),
                                 "At a relaxation of 1 each step is as long as the distance; a hit is a distance of at "
                                 "most epsilon + slope * t.");
                    const bool right_place = capped_late       ? t <= walk.t + 1e-3
                                             : walk.ended == 0 ? std::fabs(t - in[1]) < 1e-3
                                             : walk.ended == 1 ? std::fabs(t - walk.t) < 1e-3
                                                               : t > walk.t - 1e-3 && t < walk.t + walk.distance + 1e-3;
                    check.expect(right_place, said() + fmt::format(", expected {:.4f}", walk.ended ? walk.t : in[1]));
                }
            }
            if (check.failed) return;
            if (in[3] > 0.04) continue;  // a wide cone: grazing touches differ between marches
            if (in[5] < 10) {
                check.expect(ended == 2 || steps <= int(in[5]), said() + ", more than it may ask for");
                check.expect(ended != 2 || steps == int(in[5]), said() + ": it had distances left");
                check.expect(t >= -1e-4 && (right < 0 || t <= right + 1e-3),
                             said() + fmt::format(", behind the hit at {:.4f}", right));
                check.expect(ended != 1 || (right >= 0 && std::fabs(t - right) < 1e-3),
                             said() + ", where there is nothing",
                             "A ray that was stopped has hit nothing: MARCH_CAPPED.");
                if (check.failed) return;
                continue;
            }
            if (right < 0) {
                check.expect(ended == 0, said() + ", expected MARCH_MISS", "A point beyond a gap is not a hit.");
                check.expect(std::fabs(t - in[1]) < 1e-4, said() + ", expected t to be `end`");
            } else {
                check.expect(ended == 1, said() + fmt::format(", expected MARCH_HIT at {:.4f}", right),
                             ended == 2 ? "After going back, continue from the point reached."
                             : in[4] > 1
                                 ? "Take back a step over a gap, or beyond `end`, before you conclude anything from it."
                                 : "");
                check.expect(ended != 1 || std::fabs(t - right) < 0.05,
                             said() + fmt::format(", expected {:.4f}", right),
                             t > right ? "The march skipped a hit: go back if the two spheres do not touch." : "");
            }
            check.expect(steps >= 1 && steps <= 400, said() + ": no number of distances");
            if (check.failed) return;
        }
    }
    // The point of relaxation: fewer distances along an edge.
    Probe edge{.include = "../tests/11_fractals/march_counted.glsl",
               .signature =
                   "CheckMarchCounted check_march_counted(float start, float end, float epsilon, float slope, float "
                   "relaxation, "
                   "int most)",
               .inputs = {{0, 10, 1e-4, 0, 1, 400}, {0, 10, 1e-4, 0, 1.6, 400}},
               .truth =
                   [](auto) {
                       return Row{0, 0, 0, 0, 0};
                   },
               .bound = {.absolute = 1e30},
               .macros = {{"BALLS", Balls{"", {{5, 3.03, 3}, {0, 0, 0}, {0, 0, 0}}}.glsl()}}};
    const Table results = check.probe(edge);
    if (results.size() == 2)
        check.expect(whole(results[1][1]) < 0.85 * whole(results[0][1]),
                     fmt::format("past an edge it took {} distances with a relaxation of 1, and {} with 1.6",
                                 whole(results[0][1]), whole(results[1][1])),
                     "steps are relaxation times the distance");
}
