// The surroundings of a body: its air from within, clouds from below, the soft shadow of rings.
#include <fmt/core.h>

#include <array>

#include "planets_fixture.h"
#include "with_air.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "air lets through the same in both directions, from within it to space and back") {
    const Air air = air_of(BodyId::earth, glm::vec3(1.0f), 0.0047f);
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) +
                          "#include \"17_planets/air_shell.glsl\"\n"
                          "vec3 let_through(vec3 from, vec3 direction, float way) { return air_before(from, direction, "
                          "vec3(0.0, 1.0, 0.0), way, 128).transmittance; }\n",
                .signature = "vec3 let_through(vec3 from, vec3 direction, float way)",
                .macros = known_air(air)};
    for (const double height : {100.0, 9e3, 3e4})
        for (const double slope : {1.0, 0.5, 0.1}) {
            const glm::dvec3 from(0, double(air.radius) + height, 0);
            const glm::dvec3 up(std::sqrt(1 - slope * slope), slope, 0), outside = from + 2e6 * up;
            probe.inputs.push_back({from.x, from.y, from.z, up.x, up.y, up.z, 2e6});
            probe.inputs.push_back({outside.x, outside.y, outside.z, -up.x, -up.y, -up.z, 2e6});
        }
    const Table found = run_probe(gpu, probe, 3);
    for (size_t i = 0; i < found.size(); i += 2)
        for (size_t c = 0; c < 3; ++c) {
            INFO(call_text(probe, probe.inputs[i]));
            CHECK(found[i][c] == Approx(found[i + 1][c]).margin(0.01));
            CHECK(found[i][c] < 1);
        }
}

TEST_CASE_METHOD(DeviceTest,
                 "light scattered many times: the sky keeps its brightness, and loses its colour towards the night",
                 "[17.more_orders]") {
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) + "#include \"17_planets/air_shell.glsl\"\n",
                .signature = "vec3 with_more_orders(vec3 light, float sun_cosine)",
                .macros = known_air(air_of(BodyId::earth, glm::vec3(1.0f), 0.0047f))};
    const std::vector<double> cosines{-1, -0.06, 0, 0.1, 0.2, 0.31, 1};
    for (const glm::dvec3 light : {glm::dvec3(3, 1.2, 0.2), glm::dvec3(0.2, 0.5, 1.5), glm::dvec3(0.7)})
        for (const double cosine : cosines) probe.inputs.push_back({light.r, light.g, light.b, cosine});
    const Table found = run_probe(gpu, probe, 3);
    for (size_t i = 0; i < found.size(); ++i) {
        const Row& in = probe.inputs[i];
        INFO(call_text(probe, in));
        // ITU-R BT.709.
        const auto luminance = [](const Row& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
        CHECK(luminance(found[i]) == Approx(luminance(in)).epsilon(0.01));
        // Of what tells red from green a sixth is left at night, all of it by day, and ever more in between.
        const double was = in[0] - in[1], is = found[i][0] - found[i][1], left = is / was;
        if (i >= 2 * cosines.size()) {
            CHECK(std::fabs(is) < 0.05);  // grey stays nearly grey
            CHECK(found[i][2] >= found[i][0]);
        } else if (in[3] < -0.05) {
            CHECK(left == Approx(0.15).margin(0.06));
        } else if (in[3] > 0.3) {
            for (size_t c = 0; c < 3; ++c) CHECK(found[i][c] == Approx(in[c]));
        } else {
            CHECK((left > 0.1 && left < 1));
            CHECK(left > (found[i - 1][0] - found[i - 1][1]) / was + 0.02);
        }
    }
}

// Random walks are the mean of 16 pictures with a seed each: 256 walks a pixel.
TEST_CASE_METHOD(OnPlanets,
                 "the Earth's air by tables: nearer to random walks than single scattering and a fade, in colour too",
                 "[figures][17.air_tables]") {
    size = {40, 24};
    camera.fov_y_rad = 0.12f;
    planets.air.paths.value = 16;
    const auto light = [&](const char* method, const char* orders, int steps) {
        planets.air.method.set(method);
        planets.air.orders.set(orders);
        planets.air_steps.value = steps;
        return picture();
    };
    const auto error = [](const ImageRgb& found, const ImageRgb& right) {
        double off = 0, all = 0;
        for (size_t i = 0; i < right.pixels.size(); ++i) {
            const glm::dvec3 b(right.pixels[i]), d = glm::dvec3(found.pixels[i]) - b;
            off += glm::dot(d, d);
            all += glm::dot(b, b);
        }
        return std::sqrt(off / all);
    };
    const auto mean = [](const ImageRgb& of) {
        glm::dvec3 sum(0);
        for (const glm::vec3& pixel : of.pixels) sum += glm::dvec3(pixel) / double(of.pixels.size());
        return sum;
    };
    const double away = 1.25, tangent_deg = glm::degrees(std::acos(1 / away));
    for (const double sun_deg : {60.0, 10.0}) {  // elevation of the sun at the limb in the picture's middle
        look_at("earth", away, 90 - sun_deg + tangent_deg);
        const double a = glm::radians(90 - sun_deg), r = traits(BodyId::earth).radius_m;
        camera.target = glm::vec3(r * glm::dvec3(std::sin(a), 0, std::cos(a)));
        std::vector<ImageRgb> walks;
        for (unsigned i = 0; i < 16; ++i) {
            frame.seed = i;
            walks.push_back(light("truth", "multiple", 10));
        }
        ImageRgb right = walks[0], half = walks[0];
        for (size_t p = 0; p < right.pixels.size(); ++p)
            for (size_t i = 1; i < walks.size(); ++i) {
                right.pixels[p] += (walks[i].pixels[p] - right.pixels[p]) / float(i + 1);
                if (i == walks.size() / 2 - 1) half.pixels[p] = right.pixels[p];
            }
        const double doubt = error(half, right);
        const ImageRgb once = light("closed", "single", 40), faded = light("closed", "multiple", 40);
        const ImageRgb tables = light("tables", "multiple", 40);
        const glm::dvec3 seen = mean(right), by_fade = mean(faded) / seen - 1.0, by_tables = mean(tables) / seen - 1.0;
        const std::string at = fmt::format("air, sun {:.0f} degrees high at the limb", sun_deg);
        fmt::print("{}: single scattering off by {:.3f}\n", at, error(once, right));
        fmt::print("{}: a fade off by {:.3f}\n", at, error(faded, right));
        fmt::print("{}: tables off by {:.3f}\n", at, error(tables, right));
        fmt::print("{}: half of the walks off by {:.3f}\n", at, doubt);
        for (int c = 0; c < 3; ++c)
            fmt::print("{}: {} light of a fade {:+.2f}, of tables {:+.3f}\n", at, std::array{"red", "green", "blue"}[c],
                       by_fade[c], by_tables[c]);
        CHECK(error(tables, right) < 1.5 * doubt);  // all that these walks can tell
        CHECK(error(tables, right) < 0.5 * error(faded, right));
        for (int c = 0; c < 3; ++c) CHECK(std::fabs(by_tables[c]) < 0.055);  // chapter 10's bound, [10.tables]
        double last = 1;
        for (const int steps : {3, 6, 12}) {
            const double now = error(light("tables", "multiple", steps), tables);
            fmt::print("{}: tables in {} samples differ from 40 by {:.3f}\n", at, steps, now);
            CHECK(now < 0.75 * last);
            last = now;
        }
        // Light scattered once: the methods differ by the errors of the formula and of the tables.
        const ImageRgb exact = light("truth", "single", 10);
        CHECK(error(once, exact) < 0.01);
        CHECK(error(light("tables", "single", 40), exact) < 0.02);
    }
}

TEST_CASE_METHOD(OnPlanets, "at midnight the ground hides the clouds of the day side, also from below the clouds") {
    look_at("earth", 1.0001, 180);
    camera.up = {0, 1, 0};
    for (const float turn : {0.0f, 90.0f, 180.0f, 270.0f}) {
        planets.turn_deg.value = turn;
        INFO(turn);
        CHECK(sum_of(picture()) < 0.02 * double(size.x * size.y));
    }
}

TEST_CASE_METHOD(DeviceTest, "a ring's shadow is as soft as the sun's disc is wide where it falls") {
    // Instead of the tables' texel the level that was asked for: exp(-level / sine of the sun's height) comes back.
    Probe probe{.include = "common/srgb.glsl",
                .before =
                    "#define PLANETS_RINGS 0\n#define PLANETS_RINGS_ALPHA 0\n#define PLANETS_RINGS_TABLES 1\n"
                    "#define PLANETS_RINGS_SINGLE_SCATTERING 2\n"
                    "#define textureSize(map, level) ivec3(1000, 1, 4)\n"
                    "#define textureLod(map, at, level) vec4(level)\n"
                    "#include \"17_planets/rings.glsl\"\n"
                    "float shadow(vec3 point, vec3 to_sun, float sun_rad) { Rings rings; rings.inner = 1e8; "
                    "rings.outer = 2e8; return ring_shadow(rings, point, to_sun, sun_rad); }\n",
                .signature = "float shadow(vec3 point, vec3 to_sun, float sun_rad)",
                .truth =
                    [](auto in) {
                        const double sine = std::fabs(in[4]), way = -in[1] / in[4];
                        const double width = 2 * in[6] * way / std::max(sine, 0.02);  // of a disc that slants
                        return Row{std::exp(-std::log2(std::max(width / 1e5, 1.0)) / sine)};
                    },
                .bound = {.absolute = 1e-4, .relative = 1e-3}};
    for (const double sine : {0.9, 0.5, 0.3})
        for (const double sun_rad : {0.01, 0.003, 0.0005}) {
            const double way = 5e7 / sine, across = std::sqrt(1 - sine * sine);
            probe.inputs.push_back({1.5e8 - way * across, -5e7, 0, across, sine, 0, sun_rad});
        }
    CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
}

// Of a ring's two crossings with a line through the planet's middle one lies before the planet, the other behind it. The
// planet is measured in a space in which it is round, where ways are longer.
TEST_CASE_METHOD(OnPlanets, "from far away no more of the rings lies before the planet than from near",
                 "[17.ring_order]") {
    camera.fov_y_rad = 0.02f;
    look_at("saturn", 200);
    planets.ring_exposure.value = 0;
    const ImageRgb dark = picture();
    planets.ring_exposure.value = 8;
    const ImageRgb bright = picture();
    const auto is_ring = [&](int x, int y) { return std::fabs(dark.at(x, y).g - bright.at(x, y).g) > 1e-3f; };
    const double radius_px = 64 / (200 * 0.02);
    int before = 0, both = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 96; ++x) {
            if (std::hypot(x + 0.5 - 48, y + 0.5 - 32) > 0.8 * radius_px) continue;
            const bool here = is_ring(x, y), opposite = is_ring(95 - x, 63 - y);
            before += here || opposite;
            both += here && opposite;
        }
    CHECK(before > 10);
    CHECK(both == 0);
}
