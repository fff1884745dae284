// Checks of chapter 19's curves.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "19_ambiance/exercises.h"
#include "19_ambiance/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

glm::dvec3 any_point(Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

std::string text(glm::dvec3 v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

}  // namespace

CHECK_EXERCISE("19.catmull_rom",
               "three rounds of interpolation; each one divides by the distance of its own two knots, and "
               "where that is 0 the key itself is meant") {
    Random random(3);
    for (int i = 0; i < 132; ++i) {
        FourKeys keys;
        const double reach = random.logarithmic(1e-2, 1e5);
        double knot = random.uniform(-5, 5);
        // Which keys stand where the one before does: none; p1; p3; both; p2; p1 and p2; p2 and p3; all.
        const std::array<std::set<size_t>, 11> at_rest{
            {{}, {}, {}, {}, {1}, {3}, {1, 3}, {2}, {1, 2}, {2, 3}, {1, 2, 3}}};
        for (size_t k = 0; k < 4; ++k) {
            const bool rests = at_rest[size_t(i) % 11].contains(k);
            keys.points[k] = rests ? keys.points[k - 1] : any_point(random, reach);
            if (k > 0 && !rests) knot += i % 2 ? random.uniform(0.05, 3) : 1.0;
            keys.knots[k] = knot;
        }
        if (i == 0) keys = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}}, {{0, 1, 2, 3}}};
        if (i == 1) keys = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}}, {{0, 1e-9, 2e-9, 3e-9}}};
        for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0}) {
            const double t = keys.knots[1] + share * (keys.knots[2] - keys.knots[1]);
            const std::string what =
                fmt::format("catmull_rom(keys {} {} {} {} at knots {:g} {:g} {:g} {:g}, t = {:g})",
                            text(keys.points[0]), text(keys.points[1]), text(keys.points[2]), text(keys.points[3]),
                            keys.knots[0], keys.knots[1], keys.knots[2], keys.knots[3], t);
            check.call(what, [&]() -> std::string {
                const glm::dvec3 got = catmull_rom(keys, t), right = truth::catmull_rom(keys, t);
                if (glm::distance(got, right) <= 1e-9 * reach) return "";
                const char* why = !(glm::length(got) < 1e300) ? "knots are equal, and it divides by their difference"
                                  : i == 1                    ? "knots that are close to each other are not equal"
                                  : share == 0 || share == 1
                                      ? "the curve passes its second key at the second knot and its third at the third"
                                      : "";
                return what + " " + gave_text({&got.x, 3}, {&right.x, 3}) + (*why ? ": " : "") + why;
            });
            if (check.failed) return;
        }
    }
}

CHECK_EXERCISE("19.centripetal_knots", "the square root of each distance, added up; the first knot is 0") {
    Random random(5);
    for (int count = 0; count < 40; ++count) {
        std::vector<glm::dvec3> points;
        const double any_reach = random.logarithmic(1e-3, 1e4), reach = count == 7 ? 1e-8 : any_reach;
        for (int i = 0; i < count % 14; ++i)
            points.push_back(i > 0 && count > 20 && i % 3 == 1 ? points.back() : any_point(random, reach));
        const std::string what = fmt::format("centripetal_knots({} points)", points.size());
        check.call(what, [&]() -> std::string {
            const std::vector<double> got = centripetal_knots(points), right = truth::centripetal_knots(points);
            if (got.size() != right.size()) return fmt::format("{} gave {} knots", what, got.size());
            for (size_t i = 0; i < got.size(); ++i)
                if (!(std::abs(got[i] - right[i]) <= 1e-9 * right.back()))
                    return fmt::format("{}: as knot {} it {}; its point is {:.6g} from the one before", what, i,
                                       gave_text(got[i], right[i]), i ? glm::distance(points[i], points[i - 1]) : 0.0);
            return "";
        });
        if (check.failed) return;
    }
}

CHECK_EXERCISE("19.knot_at",
               "find the pair of keys first; then the slope at each of its two keys, which looks one pair farther") {
    // By hand: an even pace stays even; a pause has slope 0 at both ends; the parabola t² between its limits is itself.
    struct Line {
        std::vector<double> times_s, knots;
        double time_s, right;
    };
    const Line lines[] = {{{0, 1, 4}, {0, 2, 8}, 3, 6},
                          {{0, 1}, {5, 9}, 0.25, 6},
                          {{0, 1, 2, 3}, {0, 1, 1, 2}, 1.5, 1},
                          {{0, 1, 2}, {0, 0, 1}, 1.5, 0.375},
                          {{1, 2, 3, 4}, {1, 4, 9, 16}, 2.5, 6.25},
                          {{0, 1, 2}, {0, 1, 11}, 0.5, 0.375}};
    for (const Line& line : lines) {
        const std::string what = fmt::format("knot_at(times {}, knots {}, {} s)", fmt::join(line.times_s, " "),
                                             fmt::join(line.knots, " "), line.time_s);
        check.call(what, [&]() -> std::string {
            const double got = knot_at(line.times_s, line.knots, line.time_s);
            return std::abs(got - line.right) <= 1e-9 * line.knots.back() ? ""
                                                                          : what + " " + gave_text(got, line.right);
        });
        if (check.failed) return;
    }
    Random random(9);
    for (int i = 0; i < 80; ++i) {
        std::vector<double> times_s{random.uniform(-5, 5)}, knots{random.uniform(0, 2)};
        for (int k = 0; k < 1 + i % 9; ++k) {
            times_s.push_back(times_s.back() + random.logarithmic(0.05, 20));
            knots.push_back(knots.back() + (i % 3 == 1 && k % 2 == 1 ? 0 : random.logarithmic(0.1, 10)));
        }
        const double begin = times_s.front(), end = times_s.back();
        std::vector<double> asked{
            begin - 1, end + 1, begin, end, random.uniform(begin, end), random.uniform(begin, end)};
        for (size_t k = 0; k + 1 < times_s.size(); ++k)
            asked.insert(asked.end(), {times_s[k], (times_s[k] + times_s[k + 1]) / 2});
        for (const double time_s : asked) {
            const std::string what = fmt::format("knot_at({} keys, {:.9g} s)", times_s.size(), time_s);
            check.call(what, [&]() -> std::string {
                const double got = knot_at(times_s, knots, time_s), right = truth::knot_at(times_s, knots, time_s);
                if (std::abs(got - right) <= 1e-9 * knots.back()) return "";
                return what + " " + gave_text(got, right) +
                       (time_s < begin || time_s > end ? ": outside of the keys' times it is the nearest key's" : "");
            });
            if (check.failed) return;
        }
    }
}

CHECK_EXERCISE("19.arc_length",
               "add up the lengths of the lines first; then look for the line in which the share lies") {
    // Two lines of 1 and 3 m; then a curve that rests in its middle, once and for long: half of its length is covered
    // from a third, or a sixth, on.
    struct Line {
        const char* name;
        std::vector<double> x;
        double share, right;
    };
    const Line lines[] = {
        {"0, 1 and 4", {0, 1, 4}, 0.25, 1.0 / 2},       {"0, 1 and 4", {0, 1, 4}, 0.625, 3.0 / 4},
        {"0, 1, 1 and 2", {0, 1, 1, 2}, 0.25, 1.0 / 6}, {"0, 1, 1 and 2", {0, 1, 1, 2}, 0.5, 1.0 / 3},
        {"0, 1, 1 and 2", {0, 1, 1, 2}, 0.75, 5.0 / 6}, {"0, 1, 1, 1, 1, 1 and 2", {0, 1, 1, 1, 1, 1, 2}, 0.5, 1.0 / 6},
        {"0, 0, 0 and 1", {0, 0, 0, 1}, 0.5, 5.0 / 6},  {"0, 1e-9 and 4e-9", {0, 1e-9, 4e-9}, 0.25, 1.0 / 2}};
    for (const Line& line : lines) {
        const std::string what = fmt::format("arc_length(points at x = {}, share {})", line.name, line.share);
        check.call(what, [&]() -> std::string {
            std::vector<glm::dvec3> points;
            for (const double x : line.x) points.emplace_back(x, 0, 0);
            const double got = arc_length(points, line.share);
            if (std::abs(got - line.right) <= 1e-9) return "";
            return what + " " + gave_text(got, line.right) +
                   (line.share == 0.5 ? ": where several parameters reach it, the smallest" : "");
        });
        if (check.failed) return;
    }
    Random random(8);
    for (int i = 0; i < 80; ++i) {
        std::vector<glm::dvec3> points{any_point(random, 10)};
        const int pieces = i < 4 ? 1 : 2 + i % 37;
        for (int k = 0; k < pieces; ++k)
            points.push_back(i % 4 == 1 && k % 3 != 1 ? points.back()
                             : i % 4 == 2             ? points.back() + glm::dvec3(1, 0, 0) * double(k * k)
                             : i == 7 || i == 11      ? points.back()
                                                 : points.back() + any_point(random, random.logarithmic(1e-3, 10)));
        for (const double share : {-1.0, 0.0, 1e-9, 0.1, 0.5, random.uniform(0, 1), 0.999999, 1.0, 3.0}) {
            const std::string what = fmt::format("arc_length({} points, {:.9g})", points.size(), share);
            check.call(what, [&]() -> std::string {
                const double got = arc_length(points, share), right = truth::arc_length(points, share);
                if (std::abs(got - right) <= 1e-9) return "";
                const char* why = share <= 0 || share >= 1 ? ": the beginning and the end are the curve's own"
                                  : !(std::abs(got) <= 1)  ? ": where the curve rests there is no length to divide by"
                                                           : "";
                return what + " " + gave_text(got, right) + why;
            });
            if (check.failed) return;
        }
    }
}

CHECK_EXERCISE("19.up_without_roll",
               "the turn is about the axis at right angles to both views, by the angle between them") {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        // Looking ahead, then straight up; turned around, not at all; any angle; tiny ones and nearly opposite views.
        const glm::dvec3 from = i == 0 ? glm::dvec3(0, 0, -1) : glm::normalize(glm::dvec3(random.direction()));
        const glm::dvec3 side =
            i == 0 ? glm::dvec3(0, 1, 0) : glm::normalize(glm::cross(from, glm::dvec3(random.direction())));
        const double angle = i == 0    ? 0.5 * M_PI
                             : i == 1  ? M_PI
                             : i == 2  ? 0.0
                             : i == 3  ? M_PI - 3e-7
                             : i < 140 ? random.uniform(0, 3.1)
                             : i < 160 ? M_PI - random.logarithmic(2e-3, 0.1)
                                       : random.logarithmic(1e-9, 1e-2);
        const glm::dvec3 to = i == 0 ? side : i == 1 ? -from : std::cos(angle) * from + std::sin(angle) * side;
        const double around = i == 0 ? 0.0 : random.uniform(0, 6.28);
        const glm::dvec3 up = std::cos(around) * side + std::sin(around) * glm::cross(from, side);
        const std::string what = fmt::format("up_without_roll(up {}, from {}, to {}: {:.4g} degrees)", text(up),
                                             text(from), text(to), angle * 180 / M_PI);
        check.call(what, [&]() -> std::string {
            const glm::dvec3 got = up_without_roll(up, from, to), right = truth::up_without_roll(up, from, to);
            if (glm::distance(got, right) <= 1e-9) return "";
            const char* why = std::abs(glm::length(got) - 1) > 1e-6 ? "it is no unit vector"
                              : std::abs(glm::dot(got, to)) > 1e-6  ? "it is not at a right angle to the new view"
                              : glm::distance(got, right) > 1e-3    ? "it is rolled about the view"
                                                                    : "it is not exact";
            return what + " " + gave_text({&got.x, 3}, {&right.x, 3}) + ": " + why;
        });
        if (check.failed) return;
    }
}
