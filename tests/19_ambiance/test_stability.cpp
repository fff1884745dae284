// Where films go wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "../catch.h"
#include "19_ambiance/camera_path.h"
#include "19_ambiance/exercises.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

// Keys at even times with distances that differ by up to `ratio`.
Curve any_curve(Random& random, Spline spline, int keys, double ratio) {
    Curve curve{.spline = spline, .times_s = {}, .points = {}};
    glm::dvec3 at(0.0);
    for (int i = 0; i < keys; ++i) {
        curve.times_s.push_back(i);
        curve.points.push_back(at);
        at += random.logarithmic(1, ratio) * glm::dvec3(random.direction());
    }
    return curve;
}

struct Spread {
    double median, p95, most;
};
Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values[values.size() * 95 / 100], values.back()};
}

// Whether lines between points of the plane cross each other.
bool crosses(const std::vector<glm::dvec2>& points) {
    const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    for (size_t i = 0; i + 1 < points.size(); ++i)
        for (size_t k = i + 2; k + 1 < points.size(); ++k)
            if (side(points[i], points[i + 1], points[k]) * side(points[i], points[i + 1], points[k + 1]) < 0 &&
                side(points[k], points[k + 1], points[i]) * side(points[k], points[k + 1], points[i + 1]) < 0)
                return true;
    return false;
}

// Of the middle segment of four keys.
bool crosses(const Curve& curve) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 96; ++i) points.push_back(glm::dvec2(curve.at(1 + i / 96.0)));
    return crosses(points);
}

double turn_deg(glm::dvec3 a, glm::dvec3 b) { return glm::degrees(std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0))); }

}  // namespace

TEST_CASE("a uniform curve swings up to two chords wide of a short one, a centripetal one a fifth", "[figures]") {
    Random random(1);
    std::vector<double> uniform, centripetal;
    for (int i = 0; i < 3000; ++i) {
        Curve curve = any_curve(random, Spline::catmull_rom, 4, 10);
        uniform.push_back(
            off_the_chord({.spline = curve.spline, .times_s = curve.times_s, .points = curve.points}, 16));
        curve.spline = Spline::centripetal;
        centripetal.push_back(off_the_chord(curve, 16));
    }
    const Spread u = spread(uniform), c = spread(centripetal);
    fmt::print("off the chord, uniform: {:.2f} {:.2f} {:.2f}; centripetal: {:.2f} {:.2f} {:.2f}\n", u.median, u.p95,
               u.most, c.median, c.p95, c.most);
    CHECK(u.most > 0.8);
    CHECK(c.most < 0.5);
    CHECK(c.p95 < 0.5 * u.p95);
}

TEST_CASE("only the centripetal curve never crosses itself between two keys", "[figures][19.crossing]") {
    Random random(2);
    int uniform = 0, centripetal = 0;
    for (int i = 0; i < 2000; ++i) {
        Curve curve = any_curve(random, Spline::catmull_rom, 4, 10);
        for (glm::dvec3& point : curve.points) point.z = 0;
        uniform += crosses(curve);
        curve.spline = Spline::centripetal;
        centripetal += crosses(curve);
    }
    fmt::print("crossings of 2,000: uniform {}, centripetal {}\n", uniform, centripetal);
    CHECK(uniform > 5);
    CHECK(centripetal == 0);
}

TEST_CASE("speed varies along a centripetal curve; a table of 64 evens it out to 3%", "[figures][19.speed]") {
    Random random(3);
    std::vector<double> as_keyed;
    double worst[3] = {};
    for (int i = 0; i < 40; ++i) {
        const Curve curve = any_curve(random, Spline::centripetal, 6, 4);
        as_keyed.push_back(speed_ratio(curve, nullptr, 200));
        const int pieces[3] = {16, 64, 256};
        for (int k = 0; k < 3; ++k) {
            const std::vector<glm::dvec3> table = curve.samples(pieces[k]);
            // Lengths along the curve rather than chords: a bend has shorter steps.
            double fastest = 0, sum = 0;
            const int steps = 400, fine = 8;
            for (int s = 0; s < steps; ++s) {
                double length = 0;
                for (int f = 0; f < fine; ++f)
                    length += glm::distance(curve.at_even_speed(5.0 * (s * fine + f) / (steps * fine), table),
                                            curve.at_even_speed(5.0 * (s * fine + f + 1) / (steps * fine), table));
                fastest = std::max(fastest, length);
                sum += length;
            }
            worst[k] = std::max(worst[k], fastest * steps / sum - 1);
        }
    }
    const Spread keyed = spread(as_keyed);
    fmt::print(
        "speed ratio by keys: median {:.1f}, most {:.1f}; too fast with tables of 16, 64, 256: {:.4f} {:.4f} {:.4f}\n",
        keyed.median, keyed.most, worst[0], worst[1], worst[2]);
    CHECK(keyed.median > 2);
    CHECK(worst[0] < 0.5);
    CHECK(worst[1] < 0.5 * worst[0]);
    CHECK(worst[2] < 0.03);
}

TEST_CASE("with a table of 64 lengths the speed at a moment is even to 4%, in the median of 200 paths",
          "[19.even_speed]") {
    Random random(64);
    std::vector<double> off;
    for (int i = 0; i < 200; ++i) {
        const Curve curve = any_curve(random, Spline::centripetal, 6, 4);
        const std::vector<glm::dvec3> table = curve.samples(64);
        const int steps = 4000;
        std::vector<double> speeds;
        double sum = 0;
        for (int s = 0; s < steps; ++s) {
            speeds.push_back(glm::distance(curve.at_even_speed(5.0 * s / steps, table),
                                           curve.at_even_speed(5.0 * (s + 1) / steps, table)));
            sum += speeds.back() / steps;
        }
        double most = 0;
        for (const double speed : speeds) most = std::max(most, std::fabs(speed / sum - 1));
        off.push_back(most);
    }
    const Spread found = spread(off);
    fmt::print("speed with a table of 64: off by {:.1f}% in the median, {:.0f}% at most\n", 100 * found.median,
               100 * found.most);
    CHECK(found.median < 0.05);
    CHECK(found.median > 0.02);
}

TEST_CASE("keys are passed at their times without a jump of the speed, on the same curve", "[figures][19.timing]") {
    Random random(21);
    std::vector<double> even, smooth;
    for (int i = 0; i < 200; ++i) {
        Curve curve = any_curve(random, Spline::centripetal, 6, 10);
        const Curve before = curve;
        curve.smooth = true;
        const auto jump = [](const Curve& path) {
            return velocity_jump(path.times_s, [&](double t) { return path.at(t); });
        };
        // Knots as long as the root of a distance, passed in equal times: speeds are as two of these.
        double expected = 0;
        for (size_t k = 1; k + 1 < curve.points.size(); ++k) {
            const double quotient = std::sqrt(glm::distance(curve.points[k], curve.points[k + 1]) /
                                              glm::distance(curve.points[k - 1], curve.points[k]));
            expected = std::max(expected, 1 - std::min(quotient, 1 / quotient));
        }
        even.push_back(jump(before));
        smooth.push_back(jump(curve));
        REQUIRE(even.back() == Approx(expected).epsilon(0.01));
        for (size_t k = 0; k < curve.points.size(); ++k)
            REQUIRE(glm::distance(curve.at(curve.times_s[k]), curve.points[k]) < 1e-9);
        // Each place lies on the curve: between its two keys, at an even pace, some moment has it.
        const double t = random.uniform(curve.times_s.front(), curve.times_s.back());
        const std::vector<glm::dvec3> all = before.samples(4096);
        double nearest = 1e9;
        for (const glm::dvec3& point : all) nearest = std::min(nearest, glm::distance(point, curve.at(t)));
        REQUIRE(nearest < 0.01);
    }
    fmt::print("at a key the speed changes by {:.0f}% in the median, {:.0f}% at most; smoothed {:.2f}% at most\n",
               100 * spread(even).median, 100 * spread(even).most, 100 * spread(smooth).most);
    CHECK(spread(even).most > 0.6);
    CHECK(spread(smooth).most < 0.01);
}

TEST_CASE("keys at one place: the camera rests, and nothing is divided by 0") {
    for (const Spline spline : {Spline::linear, Spline::catmull_rom, Spline::centripetal}) {
        const Curve curve{.spline = spline,
                          .times_s = {0, 1, 2, 3, 4},
                          .points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 1, 0}}};
        const std::vector<glm::dvec3> table = curve.samples(16);
        for (double t = -1; t < 5; t += 1.0 / 64) {
            REQUIRE(glm::length(curve.at(t)) < 4);
            REQUIRE(glm::length(curve.at_even_speed(t, table)) < 4);
        }
        if (spline != Spline::catmull_rom) CHECK(curve.at(1.5) == glm::dvec3(1, 0, 0));
    }
    const Curve still{.times_s = {0, 1}, .points = {{3, 2, 1}, {3, 2, 1}}};
    CHECK(still.at_even_speed(0.5, still.samples(8)) == glm::dvec3(3, 2, 1));
}

TEST_CASE("opposite ups cancel when they are mixed; the path's up has length 1") {
    for (const auto& [apart, left] : {std::pair(90.0, 0.707), {120.0, 0.5}, {150.0, 0.259}, {170.0, 0.087}}) {
        const double a = glm::radians(apart);
        const glm::dvec3 first(0, 1, 0), second(std::sin(a), std::cos(a), 0);
        CHECK(glm::length(0.5 * (first + second)) == Approx(left).margin(0.001));
        const CameraPath path({{.time_s = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .up = first},
                               {.time_s = 1, .position = {0, 0, 5}, .target = {0, 0, 0}, .up = second}},
                              {});
        double before = 0;
        for (int i = 0; i <= 32; ++i) {
            const Camera camera = path.at(i / 32.0, {});
            CHECK(glm::length(camera.up) == Approx(1.0f).epsilon(1e-5));
            const double turned = turn_deg(first, glm::dvec3(camera.up));
            CHECK(turned == Approx(apart * i / 32).margin(0.01));
            before = turned;
        }
        CHECK(before == Approx(apart).margin(0.01));
    }
}

TEST_CASE("from one key's roll to the next the camera turns the short way, also over half a turn", "[19.roll]") {
    const auto key = [](double time_s, double roll_deg) {
        const double a = glm::radians(roll_deg);
        return CameraKey{
            .time_s = time_s, .position = {0, 0, 5}, .target = {0, 0, 0}, .up = {std::sin(a), std::cos(a), 0}};
    };
    for (const double first : {0.0, 100.0, 170.0, 175.0, -170.0, 250.0})
        for (const double turn : {20.0, -20.0, 90.0, -150.0}) {
            const CameraPath path({key(0, first), key(1, first + turn)}, {});
            const glm::dvec3 middle(path.at(0.5, {}).up), right(key(0, first + 0.5 * turn).up);
            INFO("from " << first << " by " << turn);
            CHECK(glm::distance(middle, right) < 1e-4);
        }
    // Three keys: the third goes on from the second's angle.
    const CameraPath path({key(0, 120), key(1, 200), key(2, 280)}, {});
    CHECK(glm::distance(glm::dvec3(path.at(1.5, {}).up), key(0, 240).up) < 1e-4);
}

TEST_CASE("a view that passes the zenith: a fixed up rolls by 180 degrees, the path's does not roll",
          "[figures][19.zenith]") {
    // The camera tilts from level over the zenith, half a degree beside it, to level behind.
    std::vector<CameraKey> keys;
    for (int i = 0; i <= 18; ++i) {
        const double tilt = glm::radians(10.0 * i), beside = glm::radians(0.5);
        keys.push_back(
            {.time_s = double(i),
             .position = {0, 0, 0},
             .target = {std::sin(beside), std::cos(beside) * std::sin(tilt), -std::cos(beside) * std::cos(tilt)},
             .up = {0, 1, 0}});
    }
    const auto most_roll = [](const std::vector<Camera>& cameras) {
        double most = 0;
        for (size_t i = 1; i < cameras.size(); ++i) {
            const auto axes = [](const Camera& c) {
                const glm::dvec3 view = glm::normalize(glm::dvec3(c.target) - glm::dvec3(c.position));
                const glm::dvec3 right = glm::normalize(glm::cross(view, glm::dvec3(c.up)));
                return std::pair(view, glm::cross(right, view));
            };
            const auto [from, up_before] = axes(cameras[i - 1]);
            const auto [to, up] = axes(cameras[i]);
            most = std::max(most, turn_deg(up, up_without_roll(up_before, from, to)));
        }
        return most;
    };
    std::vector<Camera> fixed, carried;
    const CameraPath path(keys, {});
    for (double t = 8; t <= 10; t += 1.0 / 60) {
        carried.push_back(path.at(t, {}));
        fixed.push_back(carried.back());
        fixed.back().up = {0, 1, 0};
    }
    fmt::print("roll between two frames near the zenith: fixed up {:.1f} degrees, path {:.1f}\n", most_roll(fixed),
               most_roll(carried));
    CHECK(most_roll(fixed) > 10);
    CHECK(most_roll(carried) < 2.5);  // the half turn to the keys' up is spread over 2 s
}

TEST_CASE("the eye in its own target: it looks on, and no number is lost") {
    const CameraPath path({{.time_s = 0, .position = {0, 0, 2}, .target = {0, 0, 0}},
                           {.time_s = 2, .position = {0, 0, 0}, .target = {0, 0, 0}},
                           {.time_s = 4, .position = {0, 0, -2}, .target = {0, 0, -4}}},
                          {Spline::linear, 0});
    for (double t = 0; t <= 4; t += 1.0 / 32) {
        const Camera camera = path.at(t, {});
        CHECK(glm::length(camera.target - camera.position) > 0);
        CHECK(glm::length(camera.up) == Approx(1.0f).epsilon(1e-5));
    }
}

TEST_CASE("an eye that passes its own target looks on there as it did a moment before") {
    const CameraPath path({{.time_s = 0, .position = {0, 0, 2}, .target = {0, 0, 0}},
                           {.time_s = 4, .position = {0, 0, -2}, .target = {0, 0, 0}}},
                          {Spline::linear, 0});
    const Camera camera = path.at(2, {});
    REQUIRE(camera.position == glm::vec3(0));
    CHECK(camera.target.z < 0);
}

TEST_CASE("a clock that adds frames drifts; one that counts them does not", "[19.clock]") {
    float added = 0;
    for (int i = 0; i < 600 * 60; ++i) added += 1.0f / 60;
    CHECK(double(added) == Approx(599.90).margin(0.01));
    CHECK(36000 / 60.0 == 600.0);
}

TEST_CASE("between two keys alone every curve is their line, at an even speed", "[19.ends]") {
    for (const Spline spline : {Spline::catmull_rom, Spline::centripetal}) {
        const Curve curve{.spline = spline, .times_s = {2, 6}, .points = {{1, 0, 0}, {5, 2, -4}}};
        for (double s = 0; s <= 1; s += 0.125) {
            const glm::dvec3 right = glm::mix(curve.points[0], curve.points[1], s);
            CHECK(glm::distance(curve.at(2 + 4 * s), right) < 1e-9);
        }
    }
}

TEST_CASE("a key that looks along its own up says nothing about a roll: up is carried on", "[19.near_up]") {
    const double beside = glm::radians(5.0);
    const CameraPath path({{.time_s = 0, .position = {0, 0, 0}, .target = {0, 0, -1}},
                           {.time_s = 1, .position = {0, 0, 0}, .target = {std::sin(beside), std::cos(beside), 0}}},
                          {});
    glm::dvec3 up(0, 1, 0);  // carried along the view by small turns
    for (int i = 1; i <= 2000; ++i) {
        const glm::dvec3 view = glm::normalize(glm::dvec3(path.at(i / 2000.0, {}).target));
        up = glm::normalize(up - glm::dot(up, view) * view);
    }
    CHECK(glm::distance(glm::dvec3(path.at(1, {}).up), up) < 0.02);
}
