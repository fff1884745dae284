// Where the terrain's noise goes wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <cmath>

#include "../common/module_fixture.h"
#include "11_fractals/terrain.h"
#include "11_fractals/truth.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

constexpr double root5 = 2.23606797749978969;

glm::dvec3 normal_of(glm::dvec2 slope) { return glm::normalize(glm::dvec3(-slope.x, 1, -slope.y)); }

double angle_deg(glm::dvec2 a, glm::dvec2 b) {
    return glm::degrees(std::acos(std::clamp(glm::dot(normal_of(a), normal_of(b)), -1.0, 1.0)));
}

/// eroded_fbm() on the device, at places of the first octave.
Table on_device(Gpu& gpu, const std::vector<NoisePlace>& places, double octaves, double erosion, double gain) {
    Probe probe{.include = "11_fractals/eroded_fbm.glsl",
                .signature = "vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain)",
                .truth = [](auto) {
                    return Row{0, 0, 0};
                }};
    for (const NoisePlace& place : places)
        probe.inputs.push_back({double(place.cell.x), double(place.cell.y), double(float(place.offset.x)),
                                double(float(place.offset.y)), octaves, double(float(erosion)), double(float(gain))});
    return run_probe(gpu, probe, 3);
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "normals of nine octaves: what d, half a chain rule and differences are off by",
                 "[figures][11.normals][11.nine_octaves]") {
    frame.end();  // probes have frames of their own
    const double erosion = 1, gain = 0.5;
    const int octaves = 9;
    struct Sum {
        double mean = 0, worst = 0;
        void add(double angle) {
            mean += angle;
            worst = std::max(worst, angle);
        }
    } as_sum, unweighted, wide, narrow, exact;
    std::vector<glm::dvec2> places;
    Random random(21);
    for (int i = 0; i < 2000; ++i) places.emplace_back(random.uniform(-40, 40), random.uniform(-40, 40));
    std::vector<NoisePlace> settled;
    for (const glm::dvec2& at : places) settled.push_back(NoisePlace::at(glm::dvec2(glm::vec2(at))));
    const Table found = on_device(gpu, settled, octaves, erosion, gain);
    double worst_height = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        NoisePlace there = settled[i];
        there.offset = glm::dvec2(glm::vec2(there.offset));
        const auto height = [&](double x, double y) {
            return truth::eroded_truth({there.cell, there.offset + glm::dvec2(x, y)}, octaves, erosion, gain).height;
        };
        const auto central = [&](double h) {
            return glm::dvec2(height(h, 0) - height(-h, 0), height(0, h) - height(0, -h)) / (2 * h);
        };
        const truth::Ground right = truth::eroded_truth(there, octaves, erosion, gain);
        as_sum.add(angle_deg(right.sum, right.slope));
        unweighted.add(angle_deg(right.unweighted, right.slope));
        wide.add(angle_deg(central(1e-2), right.slope));
        narrow.add(angle_deg(central(1e-3), right.slope));
        exact.add(angle_deg({found[i][1], found[i][2]}, right.slope));
        worst_height = std::max(worst_height, std::fabs(found[i][0] - right.height));
    }
    for (const auto& [name, sum] : {std::pair{"d taken for the slope", as_sum},
                                    {"the weight's derivative left out", unweighted},
                                    {"central differences of 0.01 cells", wide},
                                    {"central differences of 0.001 cells", narrow},
                                    {"the whole chain rule, in floats", exact}})
        fmt::print("{}: off by {:.2f} degrees in the mean, {:.1f} at most\n", name, sum.mean / 2000, sum.worst);
    fmt::print("heights in floats: off by {:.1e} of the first octave's\n", worst_height);
    CHECK(as_sum.mean / 2000 > 20);
    CHECK(unweighted.mean / 2000 > 5);
    CHECK(wide.mean / 2000 > 3);
    CHECK(narrow.mean < wide.mean);
    CHECK(exact.mean / 2000 < 0.02);
    CHECK(exact.mean < 0.1 * narrow.mean);
}

TEST_CASE_METHOD(OnDevice, "the second derivative at a cell's edge: the cubic's has a step of 12, the quintic's none",
                 "[11.second_derivative]") {
    double cubic = 0, quintic = 0;
    for (int i = 0; i < 100; ++i) {
        const double y = (i + 0.5) / 100;
        for (const bool is_cubic : {true, false}) {
            const double left = truth::noise_truth({i, 0}, {1, y}, is_cubic).second.x,
                         right = truth::noise_truth({i + 1, 0}, {0, y}, is_cubic).second.x;
            double& most = is_cubic ? cubic : quintic;
            most = std::max(most, std::fabs(left - right));
        }
    }
    fmt::print("second derivative at cells' edges: the cubic's steps are up to {:.2f}, the quintic's {:.1e}\n", cubic,
               quintic);
    CHECK(cubic > 6);
    CHECK(quintic < 1e-9);
}

TEST_CASE_METHOD(OnDevice,
                 "the same ground at negative places, after 10,000 km, and where a cell's number wraps around",
                 "[figures][11.far_places]") {
    frame.end();  // probes have frames of their own
    const double wave = 5000;
    for (const double far_m : {0.0, -3e5, 1e7, 1e9, wave * 4294967296.0}) {
        std::vector<NoisePlace> places;
        std::vector<double> right;
        double naive = 0;
        for (int i = 0; i < 400; ++i) {
            const double metres = far_m + 0.37 * i;
            const NoisePlace place = NoisePlace::at(glm::dvec2(metres, -metres / 3) / wave);
            places.push_back(place);
            right.push_back(1000 * truth::eroded_truth(place, 9, 0.15, 0.46).height);
            const double rounded = double(float(metres));
            naive = std::max(
                naive, std::fabs(1000 * truth::eroded_truth(NoisePlace::at(glm::dvec2(rounded, -rounded / 3) / wave), 9,
                                                            0.15, 0.46)
                                            .height -
                                 right.back()));
        }
        const Table found = on_device(gpu, places, 9, 0.15, 0.46);
        double worst = 0;
        for (size_t i = 0; i < places.size(); ++i) worst = std::max(worst, std::fabs(1000 * found[i][0] - right[i]));
        fmt::print("after {:.0f} km: heights are off by {:.4f} m at most; with one float for the place by {:.2f} m\n",
                   far_m / 1000, worst, naive);
        CHECK(worst < 0.02);
        if (far_m >= 1e7) CHECK(naive > 5 * worst);
    }
}

TEST_CASE(
    "where octaves end: whole ones make steps in the ground, a share of the last none; its slope is right "
    "but for the share's own",
    "[figures][11.octaves_end]") {
    const double wave = 5000, height = 1000, footprint_per_m = 1e-3;
    const auto octaves_at = [&](double metres) {
        return truth::integrate_octaves(wave, root5, footprint_per_m * metres, 11);
    };
    const auto ground = [&](double metres, double octaves) {
        const truth::Ground g = truth::eroded_truth(NoisePlace::at({metres / wave, 0.3}), octaves, 0.15, 0.46);
        return std::pair{height * g.height, height / wave * g.slope.x};
    };
    double hard = 0, soft = 0, angle = 0;
    for (double metres = 500; metres < 20000; metres += 0.3) {
        const double next = metres + 0.1;
        hard = std::max(hard, std::fabs(ground(next, std::floor(octaves_at(next))).first -
                                        ground(metres, std::floor(octaves_at(metres))).first));
        soft =
            std::max(soft, std::fabs(ground(next, octaves_at(next)).first - ground(metres, octaves_at(metres)).first));
    }
    for (double metres = 500; metres < 20000; metres += 7) {
        const double h = 1e-3;
        const double real =
            (ground(metres + h, octaves_at(metres + h)).first - ground(metres - h, octaves_at(metres - h)).first) /
            (2 * h);
        angle = std::max(angle, angle_deg({real, 0}, {ground(metres, octaves_at(metres)).second, 0}));
    }
    fmt::print(
        "over 0.1 m the ground rises by at most {:.2f} m with whole octaves, {:.2f} m with shares; where they fade "
        "the slope is off by {:.2f} degrees at most\n",
        hard, soft, angle);
    CHECK(hard > 2 * soft);
    CHECK(soft < 0.4);
    CHECK(angle < 3);
    CHECK(angle > 0);  // the share's own derivative is left out
}
