// Where skies go wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <limits>

#include "10_atmosphere/truth.h"
#include "atmosphere_fixture.h"
#include "common/check/probe.h"
#include "known_air.h"

using namespace lightwalk;

namespace {

// One number for each row.
std::vector<double> ask(const Probe& probe) {
    std::vector<double> all;
    for (const Row& row : run_probe(validated_device(), probe, 1)) all.push_back(row[0]);
    return all;
}

Probe of_air(const std::string& include, const std::string& signature, Table inputs) {
    return {.include = include,
            .before = with_known_air,
            .signature = signature,
            .inputs = std::move(inputs),
            .macros = known_air(earth_air())};
}

}  // namespace

TEST_CASE(
    "a float at a planet's radius: heights along a ray are right to a centimetre, the plain root is half a metre off",
    "[10.heights]") {
    Table inputs;
    Random random;
    for (int i = 0; i < 300; ++i)
        inputs.push_back({random.uniform(0, 50), random.uniform(0, 1), random.logarithmic(1, 1e5)});
    const auto found =
        ask(of_air("10_atmosphere/air.glsl", "float height_at(float height, float slope, float t)", inputs));
    double worst = 0, plain = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const double r = earth + inputs[i][0], slope = inputs[i][1], t = inputs[i][2];
        const double right = std::sqrt(r * r + 2 * r * slope * t + t * t) - earth;
        worst = std::max(worst, std::fabs(found[i] - right) / std::max(1.0, 1e-4 * right));
        const float rf = 6360000.0f + float(inputs[i][0]), tf = float(t);
        const float naive = std::sqrt(rf * rf + 2 * rf * float(slope) * tf + tf * tf) - 6360000.0f;
        plain = std::max(plain, std::fabs(double(naive) - right));
    }
    CHECK(worst < 0.01);
    CHECK(plain > 0.4);
}

TEST_CASE("the horizon: from 0 m exactly level, from 2 m 5,044 m away", "[10.horizon]") {
    const auto distance = [](double height, double slope) {
        return ask(of_air("10_atmosphere/view_path.glsl", "float distance_to_ground(Path path)",
                          {{height, slope, 0.5, 0.5, 0}}))[0];
    };
    CHECK(distance(0, 0) < 0);
    CHECK(distance(0, 1e-7) < 0);
    CHECK(distance(0, -1e-7) == 0);
    CHECK(distance(0, 1) < 0);
    CHECK(distance(0, -1) == 0);
    const double horizon = -std::sqrt(2 * (2 * earth + 2)) / (earth + 2);
    CHECK(distance(2, horizon * 0.9999) < 0);
    const double far = distance(2, horizon * 1.00001);
    CHECK(far > 4980);
    CHECK(far < 5044.1);
    CHECK(distance(2, -1) == Approx(2).epsilon(1e-6));
}

TEST_CASE("paths are clipped to the air: at its edge, outside, and with the planet between") {
    const auto way = [](double height, double slope, double to) {
        Probe probe = of_air("../tests/10_atmosphere/clipped.glsl", "vec2 clipped(float height, float slope, float to)",
                             {{height, slope, to}});
        const Row row = run_probe(validated_device(), probe, 2)[0];
        return glm::dvec2(row[0], row[1]);  // how long the path in the air is, and at which height it begins; or -1
    };
    CHECK(way(edge, 0.5, 1e12).x < 0);             // out, from the edge
    CHECK(way(edge, -1, edge).x == Approx(edge));  // straight down
    CHECK(way(4e5, 0.5, 1e12).x < 0);              // into space
    CHECK(way(4e5, -1, 4e5).x == Approx(edge).epsilon(1e-4));
    CHECK(way(4e5, -1, 4e5).y == edge);
    CHECK(way(4e5, -1, 2e5).x < 0);  // something stands before the air
    CHECK(way(2e7, -1, 2e7).x == Approx(edge).epsilon(1e-4));
    const double limb = -std::sqrt(1 - std::pow((earth + 50000) / (earth + 4e5), 2));
    const double chord = 2 * std::sqrt(std::pow(earth + edge, 2) - std::pow(earth + 50000, 2));
    CHECK(way(4e5, limb, 1e12).x == Approx(chord).epsilon(2e-3));  // through the limb, out again
    CHECK(way(2, 0.0, 1e12).x == Approx(std::sqrt(edge * (2 * earth + edge))).epsilon(1e-3));
}

TEST_CASE("the device's truth is that of double precision: 512 and 2048 places, from the ground, aloft, and from space",
          "[10.device_truth]") {
    const Air air = earth_air();
    const auto phase = [&](double c) { return truth::phase_cornette_shanks(c, double(air.mie_g)); };
    Table inputs;
    for (const double height : {2.0, 10000.0, 80000.0})
        for (const double slope : {0.0, 0.1, 1.0})
            for (const double sun : {-0.05, 0.0, 0.1, 0.7}) {
                const double way = truth::ray_sphere(height, slope, earth, edge).y;
                inputs.push_back({512, height, slope, sun,
                                  double(float(slope * sun + 0.6 * std::sqrt((1 - slope * slope) * (1 - sun * sun)))),
                                  double(float(way))});
            }
    inputs.push_back({512, edge, -0.17, 0.05, 0.4, 2.0e6 * 0.55});  // through the limb
    const Table found = run_probe(
        validated_device(),
        of_air("../tests/10_atmosphere/in_scatter_known.glsl", "Along in_scatter(int samples, Path path)", inputs), 6);
    double worst = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const Path path{float(in[1]), float(in[2]), float(in[3]), float(in[4]), float(in[5])};
        const glm::dvec3 right = truth::in_scatter(air, path, phase, 2048, 64);
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst, std::fabs(found[i][size_t(c)] - right[c]) / std::max(right[c], 1e-6));
    }
    fmt::print("truth of the device against double precision: {:.4f}%\n", 100 * worst);
    CHECK(worst < 0.01);
}

TEST_CASE_METHOD(
    OnAtmosphere,
    "straight up and straight down, from the ground, aloft, at the edge and from space: light, and finite") {
    for (const std::string method : {"preetham", "polynomial", "chapman", "march", "tables", "truth"})
        for (const float height : {0.0f, 2.0f, 12000.0f, 1e5f, 1.00001e5f, 4e5f, 2e7f})
            for (const float way : {1.0f, -1.0f}) {
                size = {8, 6};
                look({0, height, 0}, {0, height + way * (1000 + height), 0}, {0, 0, -1});
                atmosphere.steps.value = 8;
                INFO(method << " at " << height << " m, looking " << (way > 0 ? "up" : "down"));
                const ImageRgb seen = picture(method, 0.5f);
                CHECK(is_light(seen));
                if (height > 2e5f && way > 0)
                    CHECK(mean(seen).b == Approx(0.5));  // nothing but space: no air before it
            }
}

TEST_CASE_METHOD(OnAtmosphere, "a sun that sinks: finite and never brighter, and below -18 degrees night") {
    for (const std::string method : {"polynomial", "chapman", "march", "tables"}) {
        double before = 1e9;
        for (const float elevation : {20.0f, 5.0f, 0.0f, -2.0f, -6.0f, -12.0f, -18.0f, -90.0f}) {
            atmosphere.sun_elevation_deg.value = elevation;
            look({0, 2, 0}, {0, 2000, -1000});
            const ImageRgb sky = picture(method);
            const double light = mean(sky).g;
            INFO(method << " " << elevation);
            CHECK(is_light(sky));
            CHECK(light <= before);
            before = light;
            if (elevation <= -18) CHECK(light < 1e-6);
        }
    }
}

TEST_CASE_METHOD(OnAtmosphere,
                 "the sun's disc: darker towards its edge as measured, and all of it is the sun's light") {
    atmosphere.disc.value = 1;
    atmosphere.exposure.value = 1e-3f;
    size = {128, 128};
    look({0, 2, 0}, glm::vec3(0, 2, 0) + 1000.0f * atmosphere.to_sun());
    const double radius = glm::radians(0.5 * double(atmosphere.sun_deg)), wide = 2.4 * radius;
    camera.fov_y_rad = float(wide);
    const ImageRgb seen = picture("none");
    const double pixel = wide / 128, middle = double(seen.at(64, 64).g);
    double all = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const double away = std::hypot(x - 63.5, y - 63.5) * pixel / radius, found = double(seen.at(x, y).g);
            all += found * pixel * pixel;
            if (away > 1.02) CHECK(found == 0);
            // Hestroffer and Magnan, 1998: to the power of 0.4 of the cosine, in green.
            if (away < 0.97) CHECK(found / middle == Approx(std::pow(1 - away * away, 0.2)).epsilon(0.01));
        }
    CHECK(all == Approx(double(atmosphere.air().sun.g)).epsilon(0.01));
}

TEST_CASE_METHOD(OnAtmosphere, "the sky's table: no band at the horizon, and nothing of the ground in it",
                 "[10.sky_table]") {
    size = {24, 60};
    for (const float height : {2.0f, 3000.0f, 30000.0f}) {
        const float dip = std::sqrt(height * (2 * float(earth) + height)) / float(earth);
        look({0, height, 0}, {0, height - 1000 * dip, -1000});
        camera.fov_y_rad = 0.06f;  // 3.4 degrees, the horizon in the middle
        atmosphere.sun_elevation_deg.value = 12;
        atmosphere.sun_azimuth_deg.value = 60;
        const ImageRgb right = picture("truth"), found = picture("tables"), on_white = picture("tables", 1);
        double worst = 0, leaked = 0;
        for (int y = 0; y < 29; ++y)  // above the horizon
            for (int x = 0; x < 24; ++x) {
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst, std::fabs(double(found.at(x, y)[c] / right.at(x, y)[c]) - 1));
                leaked = std::max(leaked, double(on_white.at(x, y).r - found.at(x, y).r));
            }
        fmt::print("sky at the horizon from {} m: tables off by {:.2f}% at most\n", height, 100 * worst);
        INFO(height);
        CHECK(worst < 0.02);
        CHECK(leaked <= 1);  // background light through the air, and no more
    }
}

TEST_CASE_METHOD(OnAtmosphere, "an air without heights is none: 0 scale heights and no layer let all light through") {
    atmosphere.rayleigh_height_m.value = 0;
    atmosphere.mie_height_m.value = 0;
    atmosphere.ozone_width_m.value = 0;
    for (const std::string method : {"polynomial", "chapman", "march", "tables", "truth"}) {
        const ImageRgb seen = picture(method, 0.25f);
        INFO(method);
        CHECK(is_light(seen));
        CHECK(mean(seen).g == Approx(0.25).epsilon(1e-3));
    }
}

TEST_CASE(
    "O'Neil's fit away from the shell that it was made for: a third to five sixths of the horizon's air is missing",
    "[figures][10.oneil]") {
    struct Case {
        const char* name;
        double radius, scale, zenith, middle, horizon;
    };
    // Optical depth on the ground straight up, at 0.1 to 0.9 at worst, and level, relative to double precision.
    const Case cases[] = {{"its own: 2.5%, a quarter", 10e6, 62500, 0.03, 0.04, -0.024},
                          {"2.5%, a tenth", 10e6, 25000, 0.03, 0.13, -0.385},
                          {"Earth's molecules", earth, 8000, 0.01, 0.19, -0.56},
                          {"Earth's dust", earth, 1200, 0.01, 0.26, -0.83}};
    for (const Case& one : cases) {
        Table inputs;
        for (int i = 0; i <= 10; ++i) inputs.push_back({0, double(float(0.1 * i)), one.scale});
        const auto found = ask(of_air("10_atmosphere/closed_depth.glsl",
                                      "float polynomial_depth(float height, float slope, float scale_height)", inputs));
        double middle = 0;
        for (size_t i = 1; i < 10; ++i)
            middle = std::max(middle,
                              std::fabs(found[i] / truth::optical_depth(0, inputs[i][1], one.radius, one.scale) - 1));
        const double zenith = found[10] / truth::optical_depth(0, 1, one.radius, one.scale) - 1;
        const double horizon = found[0] / truth::optical_depth(0, 0, one.radius, one.scale) - 1;
        fmt::print("O'Neil's fit, {:26} zenith {:+.1f}% between {:.1f}% horizon {:+.1f}%\n", one.name, 100 * zenith,
                   100 * middle, 100 * horizon);
        CHECK(std::fabs(zenith) < one.zenith);
        CHECK(middle < one.middle);
        CHECK(horizon == Approx(one.horizon).margin(0.02));
    }
}

TEST_CASE("Preetham's formula: below a turbidity of 1.203 infinite, dark at the zenith; the shader's never",
          "[10.preetham]") {
    const auto b = [](double t) { return -0.3554 * t + 0.4275; };
    CHECK(b(1.2) > 0);  // exp(B / cos) grows without end towards the horizon
    CHECK(b(1.21) < 0);
    CHECK(std::isinf(std::exp(float(b(1.0)) / 1e-4f)));
    const auto zenith = [](double t, double sun) {
        return (4.0453 * t - 4.9710) * std::tan((4.0 / 9 - t / 120) * (truth::pi - 2 * sun)) - 0.2155 * t + 2.4192;
    };
    CHECK(zenith(1, 0) < 0);
    CHECK(zenith(12, truth::pi / 2) < 0);
    Table inputs;
    Random random;
    for (int i = 0; i < 400; ++i) {
        Row row;
        append(row, random.direction());
        append(row, random.direction());
        row.push_back(random.uniform(0, 20));
        inputs.push_back(row);
    }
    inputs.push_back({0, 1, 0, 0, 1, 0, 1});
    inputs.push_back({0, 0, 1, 0, 0, 1, 1});
    inputs.push_back({1, 0, 0, 0, -1, 0, 12});
    const Table found = run_probe(validated_device(),
                                  of_air("10_atmosphere/preetham.glsl",
                                         "vec3 preetham_sky(vec3 direction, vec3 to_sun, float turbidity)", inputs),
                                  3);
    for (const Row& light : found)
        for (const double c : light) CHECK((std::isfinite(c) && c >= 0 && c < 1e4));
}

TEST_CASE("phase functions: each adds up to 1, and dust's have the mean cosine that was asked for",
          "[10.phase_functions]") {
    for (const double wanted : {-0.5, 0.0, 0.3, 0.76, 0.9}) {
        const double g = double(cornette_shanks_g(float(wanted)));
        const auto cornette = [&](double c) { return truth::phase_cornette_shanks(c, g); };
        const auto henyey = [&](double c) { return truth::phase_henyey_greenstein(c, wanted); };
        CHECK(truth::over_sphere(cornette) == Approx(1).epsilon(1e-6));
        CHECK(truth::over_sphere(henyey) == Approx(1).epsilon(1e-6));
        CHECK(truth::over_sphere([&](double c) { return c * cornette(c); }) == Approx(wanted).margin(1e-5));
        CHECK(truth::over_sphere([&](double c) { return c * henyey(c); }) == Approx(wanted).margin(1e-6));
    }
    CHECK(truth::over_sphere([](double c) { return c * truth::phase_cornette_shanks(c, 0.76); }) ==
          Approx(0.81).epsilon(0.002));
    CHECK(truth::over_sphere(truth::phase_rayleigh) == Approx(1).epsilon(1e-9));
}

TEST_CASE("map coordinates are right to a hundredth of a texel of 8192, also where a device's own atan is coarse",
          "[10.map_uv]") {
    Table inputs{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    Random random;
    for (int i = 0; i < 3000; ++i) {
        glm::dvec3 d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        d = glm::normalize(i % 3 == 0   ? glm::dvec3(d.x * 1e-3, d.y, d.z)
                           : i % 3 == 1 ? glm::dvec3(d.x, d.y * 1e-3, d.z)
                                        : d);
        inputs.push_back({float(d.x), float(d.y), float(d.z)});
    }
    double worst_u = 0, worst_v = 0;
    const auto found = run_probe(
        validated_device(),
        {.include = "10_atmosphere/map_uv.glsl", .signature = "vec2 map_uv(vec3 direction)", .inputs = inputs}, 2);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const double x = float(inputs[i][0]), y = float(inputs[i][1]), z = float(inputs[i][2]);
        const double u = 0.5 + std::atan2(x, z) / 6.283185307179586;
        const double v = std::atan2(std::hypot(x, z), y) / 3.141592653589793;
        worst_u = std::max(worst_u, std::fabs(std::remainder(found[i][0] - u, 1.0)) * (y * y < 0.99 ? 1.0 : 0.0));
        worst_v = std::max(worst_v, std::fabs(found[i][1] - v));
    }
    INFO(worst_u << " " << worst_v);
    CHECK(worst_u < 0.01 / 8192);
    CHECK(worst_v < 0.01 / 8192);
}
