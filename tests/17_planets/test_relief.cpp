// Where the relief of a map of normals belongs, and where it does not.
#include <fmt/core.h>

#include <glm/gtc/constants.hpp>

#include "planets_fixture.h"
#include "with_air.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnPlanets, "relief tilts the Earth's land and leaves its water level") {
    planets.clouds.value = 0;
    planets.air.method.set("closed");  // land under bluer air would count as water
    double land = 0, water = 0;
    for (int turn = 0; turn < 360; turn += 90) {
        planets.turn_deg.value = float(turn);
        look_at("earth", 6, 60);
        planets.relief.value = 0;
        const ImageRgb level = picture();
        planets.relief.value = 4;
        const ImageRgb tilted = picture();
        // Blue is water: it is the darkest in red.
        for (size_t i = 0; i < level.pixels.size(); ++i) {
            const glm::vec3 p = level.pixels[i];
            if (p.g < 0.02f) continue;
            const double off = std::fabs(double(tilted.pixels[i].g / p.g) - 1);
            if (p.r < 0.4f * p.b)
                water = std::max(water, off);
            else if (p.r > 1.1f * p.b)
                land = std::max(land, off);
        }
    }
    INFO("land " << land << ", water " << water);
    CHECK(land > 0.1);
    CHECK(water < 0.02);
}

// The map's texels are (0.5, 0.5, 0.5) everywhere: as much to the east and the north as up.
TEST_CASE_METHOD(DeviceTest, "a normal is tilted to the east and the north, and at a pole, which has none, not at all",
                 "[17.pole_tilt]") {
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) +
                          "#include \"../tests/17_planets/known_body.glsl\"\n#include \"17_planets/body.glsl\"\n"
                          "vec3 tilted(vec3 up) { return tilted_normal(up, vec2(0.5), 0.75, 1.0); }\n",
                .signature = "vec3 tilted(vec3 up)",
                .truth =
                    [](auto in) {
                        const glm::dvec3 up(in[0], in[1], in[2]), pole(0, 1, 0);
                        if (std::hypot(up.x, up.z) < 0.02) return Row{up.x, up.y, up.z};
                        const glm::dvec3 east = glm::normalize(glm::cross(pole, up)), north = glm::cross(up, east);
                        const glm::dvec3 normal = glm::normalize(up + east + north);
                        return Row{normal.x, normal.y, normal.z};
                    },
                .bound = {.absolute = 1e-5},
                .macros = known_air(earth_air())};
    for (const double latitude_deg : {-89.0, -60.0, 0.0, 45.0, 70.0, 89.0, 90.0})
        for (const double longitude_deg : {0.0, 40.0, 200.0}) {
            const double a = glm::radians(latitude_deg), b = glm::radians(longitude_deg);
            const glm::vec3 up(glm::dvec3(std::cos(a) * std::sin(b), std::sin(a), std::cos(a) * std::cos(b)));
            probe.inputs.push_back({double(up.x), double(up.y), double(up.z)});
        }
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

// The lobe's factor is that by which a mirror of all light would send back as much as it receives.
TEST_CASE_METHOD(DeviceTest, "ice mirrors as much of an overhead sun as water ice reflects", "[17.ice]") {
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) +
                          "#include \"../tests/17_planets/known_body.glsl\"\n#include \"17_planets/body.glsl\"\n"
                          "float glossy(float part) { check_known_body(1.0); body.surface.gloss = part; "
                          "body.surface.tint = vec3(0.0); return seen_surface(check_overhead, check_overhead, "
                          "check_overhead, 1.0).x; }\n",
                .signature = "float glossy(float part)",
                .inputs = {{1}, {0.25}},
                .truth =
                    [](auto in) {
                        double sent = 0;  // of cos^40 of half the angle, over a hemisphere
                        constexpr int steps = 20000;
                        for (int i = 0; i < steps; ++i) {
                            const double angle = (i + 0.5) * glm::half_pi<double>() / steps;
                            sent += glm::two_pi<double>() * std::pow(std::cos(0.5 * angle), 40) * std::cos(angle) *
                                    std::sin(angle) * glm::half_pi<double>() / steps;
                        }
                        const double index = 1.31, root = (index - 1) / (index + 1);
                        return Row{in[0] * root * root * glm::pi<double>() / sent};
                    },
                .bound = {.relative = 0.06},
                .macros = known_air(earth_air())};
    CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
}

TEST_CASE_METHOD(DeviceTest, "a slope towards the sun is dark where the ground before it hides the sun",
                 "[17.slope_shadow]") {
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) +
                          "#define KNOWN_RELIEF 1.0\n#include \"../tests/17_planets/known_body.glsl\"\n"
                          "#include \"17_planets/body.glsl\"\nfloat lit(float high) { check_known_body(1.0); "
                          "body.surface.relief = 1.0; return seen_surface(check_overhead, check_overhead, "
                          "vec3(sqrt(1.0 - high * high), 0.0, high), 0.75).x; }\n",
                .signature = "float lit(float high)",
                .inputs = {{-0.2}, {-0.05}, {0.1}, {0.5}},
                .macros = known_air(earth_air())};
    const std::vector<Row> lit = run_probe(gpu, probe, 1);
    CHECK(lit[0][0] == 0);
    CHECK(lit[1][0] == 0);
    // Of the texels (0.75, 0.75, 0.75): a normal of (1, 1, 1), and an albedo.
    CHECK(lit[3][0] / lit[2][0] == Approx((std::sqrt(0.75) + 0.5) / (std::sqrt(0.99) + 0.1)).epsilon(1e-3));
}

// Round body of radius 1000, highest ground 10. A ray that meets the ball at longitude 0 comes from the east.
static Probe parallax_probe(const char* method, const char* texel) {
    return {.include = "common/srgb.glsl",
            .before = fmt::format("{}#define PLANETS_PARALLAX PLANETS_PARALLAX_{}\n#define KNOWN_HEIGHT_M 10.0\n"
                                  "#define KNOWN_TEXEL(uv) ({})\n#include \"../tests/17_planets/known_body.glsl\"\n"
                                  "#include \"17_planets/body.glsl\"\n"
                                  "float shifted(float angle) {{\n"
                                  "    check_known_body(1000.0);\n"
                                  "    vec3 way = -vec3(sin(angle), 0.0, cos(angle));\n"
                                  "    vec3 eye = vec3(0.0, 0.0, 1000.0) - 500.0 * way;\n"
                                  "    float nearest = -dot(eye, way), b = length(eye + nearest * way);\n"
                                  "    vec3 at = eye + ground_way(eye, way, nearest, b, 0.0) * way;\n"
                                  "    return atan(at.x, at.z);\n}}\n",
                                  with_known_air, method, texel),
            .signature = "float shifted(float angle)",
            .inputs = {{0}, {0.3}, {0.7}, {1.1}, {1.4}},
            .bound = {.absolute = 3e-6},
            .macros = known_air(earth_air())};
}

// Between two spheres a ray that passes the centre at b turns by the difference of asin(b / r).
static double turned(double angle, double height = 10) {
    const double b = 1000 * std::sin(angle);
    return angle - std::asin(b / (1000 + height));
}

TEST_CASE_METHOD(DeviceTest, "parallax: ground of height h moves by what the angle of view turns on the way from h",
                 "[17.parallax_shift]") {
    for (const char* method : {"OFFSET", "MARCH", "TRUTH"}) {
        INFO(method);
        Probe level = parallax_probe(method, "1.0");
        level.truth = [](auto in) { return Row{turned(in[0])}; };
        CHECK(worst_of(level, run_probe(gpu, level, 1)) == "");
    }
    CHECK(turned(0.3, 0.1) * 1000 == Approx(0.1 * std::tan(0.3)).epsilon(1e-3));  // of a plane: h tan θ
}

// East of 0.6° a plateau, west of it the ball: what a ray at a low angle would see behind the edge is hidden.
TEST_CASE_METHOD(DeviceTest, "parallax: a march meets the plateau before the plain, one step does not",
                 "[17.parallax_edge]") {
    const double edge = glm::radians(0.6);
    for (const char* method : {"OFFSET", "MARCH", "TRUTH"}) {
        INFO(method);
        Probe cliff = parallax_probe(method, "(uv).x > 0.5 + 0.6 / 360.0 ? 1.0 : 0.0");
        cliff.truth = [&](auto in) {
            return Row{method == std::string("OFFSET") || turned(in[0]) < edge ? 0.0 : turned(in[0])};
        };
        CHECK(turned(0.7) < edge);
        CHECK(turned(1.1) > edge);
        CHECK(worst_of(cliff, run_probe(gpu, cliff, 1)) == "");
    }
}

TEST_CASE_METHOD(OnPlanets, "parallax of Mars from 400 km: each method is nearer to the reference than the one before",
                 "[figures][17.parallax_errors]") {
    look_at("mars", 1.118, 60);
    const double r = traits(BodyId::mars).radius_m, a = glm::radians(60.0), ahead = glm::radians(8.0);
    const glm::dvec3 up(std::sin(a), 0, std::cos(a));
    camera.target = glm::vec3(r * (std::cos(ahead) * up + std::sin(ahead) * glm::dvec3(0, 1, 0)));
    camera.up = glm::vec3(up);
    camera.fov_y_rad = 0.7f;
    planets.turn_deg.value = 33.4f;
    size = {160, 90};
    const auto drawn = [&](const char* method, int steps) {
        planets.parallax.set(method);
        planets.parallax_steps.value = steps;
        return picture();
    };
    const ImageRgb right = drawn("truth", 16);
    const auto error = [&](const char* method, int steps) {
        const ImageRgb found = drawn(method, steps);
        double off = 0, all = 0;
        for (size_t i = 0; i < right.pixels.size(); ++i) {
            const glm::dvec3 b(right.pixels[i]), d = glm::dvec3(found.pixels[i]) - b;
            off += glm::dot(d, d);
            all += glm::dot(b, b);
        }
        return std::sqrt(off / all);
    };
    const double none = error("none", 1), offset = error("offset", 1), few = error("march", 4),
                 many = error("march", 16);
    fmt::print("Mars without parallax: off by {:.4f}\n", none);
    fmt::print("Mars by one step: off by {:.4f}\n", offset);
    fmt::print("Mars in 4 layers: off by {:.4f}\n", few);
    fmt::print("Mars in 16 layers: off by {:.4f}\n", many);
    CHECK(is_finite(right));
    CHECK(offset < none);
    CHECK(few < offset);
    CHECK(many < few);
}
