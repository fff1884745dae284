// Where Julia sets go wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include "julia_fixture.h"

using namespace lightwalk;

namespace {

/// The points of a grid that are in the set of a constant c = a + b i, which is one of revolution in the plane of j and
/// k: (real, i, distance from that plane's origin), the last one 0 or more.
struct Cloud {
    double spacing;
    std::vector<glm::dvec3> inside;

    Cloud(glm::dvec4 c, double step, int iterations) : spacing(step) {
        const int n = static_cast<int>(1.6 / step);
        for (int x = -n; x <= n; ++x)
            for (int y = -n; y <= n; ++y)
                for (int r = 0; r <= n; ++r) {
                    const glm::dvec3 at(x * step, y * step, r * step);
                    if (truth::in_julia({at, 0}, c, iterations)) inside.push_back(at);
                }
    }
    double distance(glm::dvec3 from) const {
        double nearest = 1e9;
        for (const glm::dvec3& point : inside) {
            const glm::dvec3 way = point - from;
            nearest = std::min(nearest, glm::dot(way, way));
        }
        return std::sqrt(nearest);
    }
};

struct Overstep {
    double mean = 0;  ///< bound, in ways to the set
    double share = 0,
           worst = 0;  ///< of points with a bound beyond the distance to the set; the longest, relative to it
};

Overstep overstep(const Cloud& cloud, glm::dvec4 c, double escape, int points) {
    Overstep found;
    Random random(5);
    int tried = 0;
    for (int i = 0; i < points; ++i) {
        const glm::dvec3 at(random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6), random.uniform(0, 1.6));
        const double bound = truth::julia_distance({at, 0}, c, 200, escape);
        if (bound <= 0) continue;
        const double way = cloud.distance(at);  // to a point of the set, if not to the nearest
        if (way < 10 * cloud.spacing) continue;
        ++tried;
        found.share += bound > way;
        found.mean += bound / way;
        found.worst = std::max(found.worst, bound / way);
    }
    found.share /= tried;
    found.mean /= tried;
    return found;
}

const glm::dvec4 connected[] = {{-1, 0.2, 0, 0}, {-0.2, 0.6, 0, 0}, {-0.6, 0.3, 0, 0}};
const glm::dvec4 dust{0.285, 0.01, 0, 0};

}  // namespace

TEST_CASE("the distance bound: at an escape radius of 2 it oversteps, from 4 on it does not for connected sets",
          "[figures][11.bound]") {
    double worst_at_2 = 0, worst_share = 0;
    for (const glm::dvec4& c : connected) {
        const Cloud cloud(c, 0.025, 200);
        for (const double escape : {2.0, 4.0, 8.0, 64.0}) {
            const Overstep found = overstep(cloud, c, escape, 500);
            fmt::print(
                "c = {:5} + {:4} i, escape at {:2}: {:.1f}% of points overstep, the longest bound is {:.2f} of "
                "the way, the mean one {:.2f}\n",
                c.x, c.y, escape, 100 * found.share, found.worst, found.mean);
            INFO(c.x << " " << escape);
            if (escape == 2) {
                worst_at_2 = std::max(worst_at_2, found.worst);
                worst_share = std::max(worst_share, found.share);
            } else {
                CHECK(found.worst < 0.95);
                CHECK(found.worst > 0.5);  // nor is it a bound that anybody could double
            }
        }
    }
    CHECK(worst_at_2 > 1.2);
    CHECK(worst_share > 0.004);
}

TEST_CASE("the distance bound of a set that falls to dust oversteps at any escape radius", "[figures][11.bound]") {
    const Cloud cloud(dust, 0.0125, 60);  // points that have not escaped after 60 iterations: those around the dust
    for (const double escape : {2.0, 8.0, 64.0}) {
        double worst = 0;
        Random random(3);
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1));
            const double bound = truth::julia_distance({at, 0}, dust, 400, escape), way = cloud.distance(at);
            if (way > 4 * cloud.spacing) worst = std::max(worst, bound / way);
        }
        // Where orbits pass near 0 the bound has poles: around a point that comes upon 0 in its n-th turn.
        glm::dvec4 pole(0);
        double at_pole = 0;
        for (const double near : {1e-3, 1e-2, 3e-2})
            at_pole = std::max(at_pole, truth::julia_distance(pole + glm::dvec4(near, 0, 0, 0), dust, 400, escape));
        fmt::print(
            "dust, escape at {:2}: the longest bound is {:.2f} of the way; beside 0 it is {:.3f} m, the way {:.3f} "
            "m\n",
            escape, worst, at_pole, cloud.distance({0, 0, 0}));
        CHECK(at_pole > 2 * cloud.distance({0, 0, 0}));
    }
}

TEST_CASE_METHOD(OnJulia, "every method's rays end where double precision says, as near as it says itself") {
    julia.constant.set("knot");
    draw();
    std::vector<double> right;
    for (size_t i = 0; i < size_t(size.x) * size.y; i += 7) right.push_back(depth(i));
    const auto off = [&](const char* method) {
        julia.method.set(method);
        draw();
        const auto all = marched();
        int wrong = 0, hits = 0;
        double mean = 0, early = 0;
        for (size_t k = 0; k < right.size(); ++k) {
            const glm::vec4& one = all[7 * k];
            if ((one.z != 0) != (right[k] >= 0)) {
                ++wrong;
            } else if (right[k] >= 0) {
                ++hits;
                mean += std::fabs(double(one.x) - right[k]);
                early = std::max(early, double(one.x) - right[k]);
            }
        }
        fmt::print("{:8}: depth is off by {:.5f} m, {} of {} rays misjudged, none later than by {:.5f} m\n", method,
                   mean / hits, wrong, right.size(), early);
        CHECK(wrong < 0.16 * double(right.size()));
        return std::pair{mean / hits, early};
    };
    julia.epsilon_m.value = 2e-4f;
    julia.step_m.value = 0.01f;
    julia.most_steps.value = 1024;
    const auto [exact, late_exact] = off("exact");
    const auto [distance, late_distance] = off("distance");
    const auto [relaxed, late_relaxed] = off("relaxed");
    const auto [cone, late_cone] = off("cone");
    const auto [fixed, late_fixed] = off("fixed");
    CHECK(exact < 0.001);
    CHECK(distance < 0.006);
    CHECK(relaxed < 0.006);
    CHECK(cone < 0.12);
    CHECK(fixed < 0.06);
    // No ray ends behind the set: no method has leapt over anything.
    for (const double late : {late_distance, late_relaxed, late_cone}) CHECK(late < 2e-3);
}

TEST_CASE_METHOD(OnJulia, "relaxation: some saves distances, twice the distance saves none",
                 "[figures][11.relaxation]") {
    julia.method.set("relaxed");
    julia.epsilon_m.value = 1e-3f;
    std::vector<double> steps;
    for (const float relaxation : {1.0f, 1.2f, 1.4f, 1.6f, 1.8f, 2.0f}) {
        julia.relaxation.value = relaxation;
        draw();
        steps.push_back(mean_steps());
        fmt::print("relaxation {:.1f}: {:.2f} distances a pixel\n", relaxation, steps.back());
    }
    CHECK(steps[2] < 0.9 * steps[0]);
    CHECK(*std::min_element(steps.begin(), steps.end()) < steps[5]);
}

TEST_CASE_METHOD(OnJulia, "rays along an edge creep: they are stopped, counted, and seen as white", "[11.edge_rays]") {
    julia.method.set("distance");
    julia.epsilon_m.value = 1e-5f;
    julia.most_steps.value = 40;
    julia.show.set("steps");
    draw();
    const auto all = marched();
    const ImageRgb seen = picture();
    int capped = 0, white = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i].y <= 40.5f);
        capped += all[i].z == 2;
        white += seen.pixels[i] == glm::vec3(1.0f);
    }
    CHECK(capped > 20);
    CHECK(white == capped);
    julia.most_steps.value = 2000;
    draw();
    int left = 0;
    for (const glm::vec4& one : marched()) left += one.z == 2;
    CHECK(left < capped / 10);
}

TEST_CASE_METHOD(OnJulia, "the camera inside the set: every pixel hits at once, and its colour is a number",
                 "[11.inside]") {
    julia.constant.set("custom");
    julia.c_xyz.value = {-0.1f, 0.0f, 0.0f};
    for (const char* method : {"fixed", "distance", "relaxed", "cone", "exact"})
        for (const char* normal : {"analytic", "difference"}) {
            julia.method.set(method);
            julia.normal.set(normal);
            camera.position = {0.01f, 0.02f, 0.03f};
            camera.target = {1, 0, 0};
            draw();
            for (const glm::vec4& one : marched()) CHECK((one.x == 0 && one.z == 1 && one.y <= 2.0f));
            for (const glm::vec3& pixel : picture().pixels) CHECK(std::isfinite(pixel.r + pixel.g + pixel.b));
        }
    // No distance grows there in any direction: the normal faces the ray.
    julia.normal.set("difference");
    julia.show.set("normals");
    draw();
    const ImageRgb seen = picture();
    for (size_t i = 0; i < seen.pixels.size(); i += 17)
        CHECK(glm::length(glm::dvec3(seen.pixels[i]) - (0.5 - 0.5 * direction(i))) < 1e-3);
}

TEST_CASE_METHOD(OnJulia, "normals: analytic ones are those of double precision, differences are off by degrees",
                 "[11.normals]") {
    julia.method.set("exact");
    julia.show.set("normals");
    julia.escape.value = 32;
    const auto angle = [&](const char* normal, float difference_m) {
        julia.normal.set(normal);
        julia.difference_m.value = difference_m;
        draw();
        const auto all = marched();
        const ImageRgb seen = picture();
        std::vector<double> angles;
        for (size_t i = 0; i < all.size(); ++i) {
            if (all[i].z != 1) continue;
            const glm::dvec3 at = glm::dvec3(camera.position) + double(all[i].x) * direction(i);
            const glm::dvec3 right = truth::julia_normal({at, double(julia.slice)}, glm::dvec4(julia.constant_at(0)),
                                                         40, double(julia.escape));
            const glm::dvec3 found = glm::normalize(2.0 * glm::dvec3(seen.pixels[i]) - 1.0);
            if (glm::length(right) > 0) angles.push_back(std::acos(std::clamp(glm::dot(found, right), -1.0, 1.0)));
        }
        std::sort(angles.begin(), angles.end());
        const double median = glm::degrees(angles[angles.size() / 2]),
                     ninety = glm::degrees(angles[angles.size() * 9 / 10]);
        fmt::print("normals {} {:g} m: off by {:.3f} degrees in the median, {:.2f} for a tenth\n", normal, difference_m,
                   median, ninety);
        return std::pair{median, ninety};
    };
    const auto analytic = angle("analytic", 2e-4f);
    const auto fine = angle("difference", 2e-5f), middle = angle("difference", 2e-4f),
               coarse = angle("difference", 2e-3f);
    CHECK(analytic.first < 0.5);
    CHECK(analytic.second < 4);
    for (const auto& difference : {fine, middle, coarse}) CHECK(difference.first > 2 * analytic.first);
}

TEST_CASE_METHOD(OnJulia, "the set of the constant 0 is the unit ball, and so are its normals in each slice",
                 "[11.ball]") {
    julia.constant.set("custom");
    julia.c_xyz.value = glm::vec3(0);
    julia.c_k.value = 0;
    julia.show.set("normals");
    julia.normal.set("analytic");
    for (const float slice : {0.0f, 0.6f}) {  // of radius 1 and 0.8
        julia.slice.value = slice;
        draw();
        const auto all = marched();
        const ImageRgb seen = picture();
        size_t hits = 0;
        for (size_t i = 0; i < all.size(); ++i) {
            if (all[i].z != 1) continue;
            const glm::dvec3 right = glm::normalize(glm::dvec3(camera.position) + double(all[i].x) * direction(i));
            CHECK(glm::length(2.0 * glm::dvec3(seen.pixels[i]) - 1.0 - right) < 0.01);
            ++hits;
        }
        CHECK(hits > 50);
    }
}

TEST_CASE_METHOD(OnJulia, "the constant's way through the gallery is smooth, passes through it, and closes") {
    julia.constant.set("morph");
    const glm::vec4 first = julia.constant_at(0);
    CHECK(glm::length(julia.constant_at(24) - first) < 1e-6f);
    CHECK(glm::length(julia.constant_at(24e5) - first) < 1e-5f);
    for (double t = 0; t < 24; t += 0.05)
        CHECK(glm::length(julia.constant_at(t + 0.05) - julia.constant_at(t)) < 0.05f);
    julia.constant.set("reef");
    CHECK(glm::length(julia.constant_at(3) - glm::vec4(-0.2f, 0.8f, 0, 0)) < 1e-7f);
}

TEST_CASE_METHOD(OnJulia, "a slice where the set is not, and one through it") {
    julia.slice.value = 1.9f;
    draw();
    for (const glm::vec4& one : marched()) CHECK(one.z == 0);
    julia.slice.value = 0.3f;
    draw();
    int hits = 0;
    for (const glm::vec4& one : marched()) hits += one.z == 1;
    CHECK(hits > 200);
}
