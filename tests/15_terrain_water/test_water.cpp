// Water: its waves and its mirror image against double precision, and where they fail.
#include <fmt/core.h>

#include <cmath>
#include <cstring>

#include "15_terrain_water/exercises.h"
#include "common/gpu/glsl.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

constexpr double in_degrees = 180 / M_PI;

// `count` waves of equal steepness k A with a sum of Q k A equal to `steepness`; directions within 60 degrees of +x.
std::vector<WaveData> random_waves(Random& random, int count, double steepness) {
    std::vector<WaveData> all;
    for (int i = 0; i < count; ++i) {
        const double k = 2 * M_PI / random.logarithmic(2, 20), angle = random.uniform(-1.05, 1.05);
        const double amplitude = 0.1 / k;
        all.push_back({.k = glm::vec2(k * std::cos(angle), k * std::sin(angle)),
                       .amplitude = float(amplitude),
                       .steepness = float(steepness / (count * k * amplitude)),
                       .phase = float(random.uniform(0, 6.28))});
    }
    return all;
}

glm::dmat3 slopes_of(const std::vector<WaveData>& waves, glm::dvec2 at) {
    glm::dmat3 sum(0.0);
    for (const WaveData& w : waves)
        sum += truth::gerstner_slopes(at, glm::dvec2(w.k), double(w.amplitude), double(w.steepness), double(w.phase));
    return sum;
}

double jacobian_of(const glm::dmat3& s) { return (1 + s[0].x) * (1 + s[2].z) - s[0].z * s[2].x; }

}  // namespace

TEST_CASE_METHOD(OnWater, "after 1e5 s each wave's phase is right; a float's would be off by an eighth of a radian",
                 "[15.late_waves]") {
    water.shortest_m.value = 0.5f;
    water.waves.value = 16;
    const double late_s = 1e5;
    const std::vector<WaveData> start = water.waves_at(0), late = water.waves_at(late_s);
    for (size_t i = 0; i < late.size(); ++i) {
        const long double k = glm::length(glm::dvec2(start[i].k));
        // The wavelength as the module has it: k is stored as floats, the frequency is not made from those.
        const long double length = 12.0L * std::pow(0.5L / 12.0L, static_cast<long double>(i) / 15);
        CHECK(double(2 * M_PIl / length / k) == Approx(1).epsilon(1e-6));
        const long double omega = std::sqrt(9.81L * 2 * M_PIl / length);
        const long double right = std::fmod(omega * late_s + 2.399963L * i, 2 * M_PIl);
        CHECK(std::fabs(std::remainder(double(right) - double(late[i].phase), 2 * M_PI)) < 2e-6);
    }
    const float omega = float(std::sqrt(9.81 * 2 * M_PI / 0.5));
    CHECK(std::nextafter(omega * 1e5f, 1e9f) - omega * 1e5f == 0.125f);
}

TEST_CASE("the shortcut for the normal is exact for one wave; of four it is over 50 degrees off at the limit of loops",
          "[15.normal_shortcut]") {
    Random random(15);
    for (const double steepness : {0.3, 0.6, 0.8, 1.0}) {
        double mean = 0, most = 0, single = 0;
        size_t count = 0;
        for (int set = 0; set < 60; ++set)
            for (const int waves : {1, 4}) {
                const std::vector<WaveData> all = random_waves(random, waves, steepness);
                for (int i = 0; i < 400; ++i) {
                    const glm::dvec2 at(random.uniform(-200, 200), random.uniform(-200, 200));
                    const glm::dmat3 s = slopes_of(all, at);
                    if (jacobian_of(s) <= 1e-3) continue;
                    double up = 1;  // 1 - sum of Q k A sin
                    glm::dvec2 along(0);
                    for (const WaveData& w : all) {
                        const double t = glm::dot(glm::dvec2(w.k), at) - double(w.phase),
                                     k = glm::length(glm::dvec2(w.k));
                        along -= glm::dvec2(w.k) * double(w.amplitude) * std::cos(t);
                        up -= double(w.steepness) * k * double(w.amplitude) * std::sin(t);
                    }
                    const glm::dvec3 short_cut = glm::normalize(glm::dvec3(along.x, up, along.y));
                    const double off = in_degrees * std::acos(std::min(glm::dot(short_cut, truth::normal_of(s)), 1.0));
                    if (waves == 1)
                        single = std::max(single, off);
                    else {
                        mean += (off - mean) / double(++count);
                        most = std::max(most, off);
                    }
                }
            }
        fmt::print(
            "sum of Q k A {}: the shortcut is {:.2f} degrees off in the mean, {:.1f} at most (one wave: {:.4f})\n",
            steepness, mean, most, single);
        CHECK(single < 0.01);
        CHECK(mean > 0.1);
        CHECK(most > 1);
        if (steepness == 1.0) CHECK(most > 50);
    }
}

TEST_CASE("beyond a sum of 1 the surface folds: often with one wave, hardly with four, not with sixteen",
          "[15.folds]") {
    Random random(1);
    const auto folded = [&](int waves, double steepness) {
        size_t count = 0, all = 0;
        for (int set = 0; set < 40; ++set) {
            const std::vector<WaveData> w = random_waves(random, waves, steepness);
            for (int i = 0; i < 1000; ++i, ++all)
                count += jacobian_of(slopes_of(w, {random.uniform(-500, 500), random.uniform(-500, 500)})) < 0;
        }
        return double(count) / double(all);
    };
    const double one = folded(1, 1.2), four = folded(4, 1.2), sixteen = folded(16, 1.2);
    fmt::print("folded at a sum of 1.2: {:.1f}%, {:.2f}%, {:.3f}% of 1, 4, 16 waves\n", 100 * one, 100 * four,
               100 * sixteen);
    CHECK(one == Approx(std::acos(1 / 1.2) / M_PI).margin(0.01));
    CHECK(four < 0.02);
    CHECK(four > 0);
    CHECK(sixteen < 1e-3);
    CHECK(folded(1, 0.99) == 0);
}

TEST_CASE("the height above a place: a fixed point comes closer with each round, the slower the steeper the waves",
          "[15.fixed_point]") {
    Random random(2);
    for (const double steepness : {0.6, 0.95}) {
        double off[4] = {};
        double sum = 0;
        for (int set = 0; set < 40; ++set) {
            const std::vector<WaveData> w = random_waves(random, 4, steepness);
            for (const WaveData& one : w) sum += double(one.amplitude) / 40;
            for (int i = 0; i < 50; ++i) {
                const glm::dvec2 place(random.uniform(-100, 100), random.uniform(-100, 100));
                const double right = height_at(w, place, 200);
                for (int rounds = 0; rounds < 4; ++rounds)
                    off[rounds] = std::max(off[rounds], std::fabs(height_at(w, place, rounds) - right));
            }
        }
        fmt::print("sum {}: height off by {:.0f}/{:.0f}/{:.0f}/{:.1f}% of the amplitudes after 0/1/2/3 rounds\n",
                   steepness, 100 * off[0] / sum, 100 * off[1] / sum, 100 * off[2] / sum, 100 * off[3] / sum);
        for (int rounds = 0; rounds < 3; ++rounds) CHECK(off[rounds + 1] < off[rounds]);
        CHECK(off[0] > 0.2 * sum);
        CHECK(off[3] < (steepness < 0.9 ? 0.06 : 0.2) * sum);
    }
}

TEST_CASE("Voronoi noise from 2x2 cells misses nearest points, from 3x3 cells hardly ever", "[15.voronoi]") {
    Probe probe{.include = "15_terrain_water/voronoi.glsl",
                .signature = "vec2 voronoi(vec2 at, int period, int reach)",
                .inputs = {}};
    Random random(6);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 20000; ++i) places.emplace_back(random.uniform(0, 32), random.uniform(0, 32));
    for (const int reach : {2, 0, 1})
        for (const glm::dvec2& at : places) probe.inputs.push_back({at.x, at.y, 32, double(reach)});
    const Table found = run_probe(validated_device(), probe, 2);
    const size_t n = places.size();
    double wrong[2][2] = {}, most = 0;
    for (int method = 0; method < 2; ++method)
        for (size_t i = 0; i < n; ++i)
            for (size_t f = 0; f < 2; ++f) {
                const double off = found[(size_t(method) + 1) * n + i][f] - found[i][f];
                CHECK(off > -1e-5);
                wrong[method][f] += (off > 1e-5) / double(n);
                if (f == 0) most = std::max(most, off);
            }
    fmt::print("2x2 cells: F1 wrong at {:.2f}% (by {:.2f} at most), F2 at {:.1f}%; 3x3: {:.3f}% and {:.3f}%\n",
               100 * wrong[0][0], most, 100 * wrong[0][1], 100 * wrong[1][0], 100 * wrong[1][1]);
    CHECK(wrong[0][0] == Approx(0.01).margin(0.008));
    CHECK(wrong[0][1] == Approx(0.13).margin(0.04));
    CHECK(wrong[1][0] == 0);
    CHECK(wrong[1][1] < 0.001);
}

TEST_CASE("Schlick's formula for water, seen from the air, is within 0.06 of Fresnel's", "[15.schlick]") {
    double most = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double c = i / 1000.0;
        most = std::max(
            most, std::fabs(truth::fresnel_water(c, 1, 1.333) - truth::fresnel_exact(std::max(c, 1e-9), 1, 1.333)));
    }
    fmt::print("Schlick's formula is off by {:.4f} at most\n", most);
    CHECK(most < 0.06);
    CHECK(most > 0.005);
}

TEST_CASE_METHOD(OnWater, "every method is finite above, at and under the water line, from straight up and down") {
    for (const char* method : {"flat", "sines", "gerstner", "fft"})
        for (const char* reflection : {"none", "cube", "screen_space", "planar"})
            for (const float height : {5.0f, 0.001f, 0.0f, -0.001f, -3.0f}) {
                INFO(method << " " << reflection << " " << height);
                camera.position = {0, height, 0};
                camera.target = {3, height + (height < 0 ? 1.0f : -1.0f), -20};
                CHECK(all_finite(picture(method, reflection, 2.5f)));
            }
    camera.position = {0, 50, 0};
    camera.target = {0, 0, 0.001f};
    CHECK(all_finite(picture("gerstner", "planar")));
    camera.position = {0, -5, 0};
    camera.target = {0, 0, 0.001f};
    CHECK(all_finite(picture("gerstner", "planar")));
}

TEST_CASE_METHOD(OnWater, "the water covers the picture up to the horizon") {
    camera.position = {0, 30, 0};
    camera.target = {0, 30, -100};
    const ImageRgb seen = picture("flat", "none");
    // Row 32 begins at the horizon.
    for (uint32_t x = 0; x < size.x; ++x) {
        CHECK(glm::distance(seen.pixels[31 * size.x + x], glm::vec3(background)) < 1e-3f);
        for (uint32_t y = 33; y < size.y; ++y)
            CHECK(glm::distance(seen.pixels[y * size.x + x], glm::vec3(background)) > 1e-2f);
    }
}

TEST_CASE_METHOD(OnWater, "level water shows a wall upside down where the wall is, and not its own ground") {
    Wall wall(owner);
    water.mirror.scale.value = 1.0f;
    const ImageRgb seen = picture("flat", "planar", 0, {wall});
    const View view = view_of(camera, size);
    const auto pixel_of = [&](glm::vec3 place) {
        const glm::vec4 clip = view.view_projection * glm::vec4(place, 1.0f);
        return glm::vec2(clip.x / clip.w * 0.5f + 0.5f, clip.y / clip.w * 0.5f + 0.5f) * glm::vec2(size);
    };
    const auto red_at = [&](glm::vec3 place) {
        const glm::uvec2 p(pixel_of(place));
        return double(seen.pixels[p.y * size.x + p.x].r);
    };
    // A reflection in level water is seen at the mirror image of the point.
    CHECK(red_at({-4, -3.0f, -40}) > 0.2);  // of the wall 3 m above the water
    CHECK(red_at({-7, -5.0f, -40}) > 0.2);
    CHECK(red_at({-4, -8.0f, -40}) < 0.1);  // higher than the wall
    CHECK(red_at({4, -3.0f, -40}) < 0.1);   // beside it
    // Its depth is that of a camera below the water: the wall stands 40 m along the view, less where that looks down.
    const View below = view_of(mirrored_camera(camera, 0), size);
    const std::vector<std::byte> bytes = gpu.read_back(water.mirror.depth());
    const auto depth_at = [&](glm::vec3 place) {
        const glm::vec4 clip = below.view_projection * glm::vec4(place, 1.0f);
        const glm::uvec2 p(glm::vec2(clip.x / clip.w * 0.5f + 0.5f, clip.y / clip.w * 0.5f + 0.5f) * glm::vec2(size));
        float depth = 0;
        std::memcpy(&depth, &bytes[(p.y * size.x + p.x) * 4], 4);
        return std::pair(double(depth), double(clip.z / clip.w));
    };
    for (const glm::vec3 place : {glm::vec3(-4, 3, -40), glm::vec3(-7, 5, -40), glm::vec3(-1, 1, -40)}) {
        const auto [found, right] = depth_at(place);
        CHECK(found == Approx(right).epsilon(0.02));
    }
    CHECK(depth_at({4, 3, -40}).first == 0);
    // The mirror image omits everything below the water: from above it would stand before the sky.
    wall.bottom = -3;
    wall.top = -0.5f;
    water.absorption.value = glm::vec3(20);  // nothing shows through
    const ImageRgb sunk = picture("flat", "planar", 0, {wall});
    double red = 0;
    for (const glm::vec3& p : sunk.pixels) red = std::max(red, double(p.r) - double(p.g));
    wall.top = 6;
    CHECK(red < 0.2);
}

TEST_CASE_METHOD(OnWater, "waves of length 0, or shortest above longest: one clear line") {
    for (const char* name : {"0", "-1", "nan"}) CHECK_THROWS_AS(water.longest_m.set(name), InputError);
    water.shortest_m.value = 20;
    try {
        owner.prepare_all(gpu, scene);
        FAIL("accepted");
    } catch (const InputError& e) {
        const std::string said = e.what();
        CHECK(said.find("water.shortest_m: 20 m") != said.npos);
        CHECK(said.find('\n') == said.npos);
    }
}

TEST_CASE_METHOD(DeviceTest, "the Jacobian of a surface is the area of what was a square of 1 m at rest") {
    Probe probe{.include = "15_terrain_water/water_surface.glsl",
                .signature = "float jacobian(mat3 slopes)",
                .inputs = {},
                .truth = [](auto in) { return Row{(1 + in[0]) * (1 + in[8]) - in[2] * in[6]}; },
                .bound = {.absolute = 1e-5, .relative = 1e-5},
                .macros = {{"WATER_METHOD", "0"},
                           {"WATER_METHOD_SINES", "1"},
                           {"WATER_METHOD_GERSTNER", "2"},
                           {"WATER_METHOD_FFT", "3"}}};
    Random random(15);
    for (int i = 0; i < 50; ++i) {
        probe.inputs.emplace_back();
        for (int k = 0; k < 9; ++k) probe.inputs.back().push_back(random.uniform(-1.5, 1.5));
    }
    CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
}
