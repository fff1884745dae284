// Reading maps of bodies: no row beyond the poles, and levels by the pixel's footprint.
#include "planets_fixture.h"
#include "with_air.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "a map is read no nearer to its poles than half a texel of the level that is read") {
    // Instead of a texel where it is asked for, in a map of 100 rows.
    Probe probe{.include = "common/srgb.glsl",
                .before =
                    "#define textureSize(map, level) ivec2(200, 100)\n"
                    "#define textureLod(map, at, level) vec4(at, level, 1.0)\n"
                    "#define sampler2D int\n"
                    "#include \"17_planets/map_lookup.glsl\"\n"
                    "vec3 read_at(vec2 uv, float footprint_rad) { return map_texel(0, uv, footprint_rad).xyz; }\n",
                .signature = "vec3 read_at(vec2 uv, float footprint_rad)",
                .truth =
                    [](auto in) {
                        const double lod = std::max(std::log2(in[2] * 100 / glm::pi<double>()), 0.0);
                        const double edge = std::min(0.5 * std::exp2(std::ceil(lod)) / 100, 0.5);
                        return Row{in[0], std::clamp(in[1], edge, 1 - edge), lod};
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-5}};
    for (const double v : {0.0, 0.001, 0.02, 0.3, 0.7, 0.99, 1.0})
        for (const double footprint : {1e-4, 0.05, 0.15, 0.4, 3.0, 9.0})
            for (const double u : {-0.2, 0.5, 1.0}) probe.inputs.push_back({u, v, footprint});
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

namespace {

// The square root of the area of a ball that a pixel covers, over its radius: the pixel's edges are followed to the ball.
double covered_rad(double pixel, double mu) {
    const double middle = std::sqrt(1 - mu * mu),
                 along = std::asin(std::min(middle + 0.5 * pixel, 1.0)) - std::asin(middle - 0.5 * pixel);
    return std::sqrt(along * 2 * std::asin(0.5 * pixel));
}

// `covered` is the footprint of a pixel, a share of the radius, at a cosine.
Probe slanting(const std::string& kind, const std::string& covered) {
    Probe probe{.include = "common/srgb.glsl",
                .before = std::string(with_known_air) + kind + "#include \"../tests/17_planets/known_body.glsl\"\n" +
                          "#include \"17_planets/body.glsl\"\nfloat covered(float mu, float pixel) { " + covered +
                          " }\n",
                .signature = "float covered(float mu, float pixel)",
                .truth = [](auto in) { return Row{covered_rad(in[1], in[0])}; },
                .bound = {.relative = 0.01},
                .macros = known_air(earth_air())};
    for (const double mu : {1.0, 0.9, 0.6, 0.3, 0.1})
        for (const double pixel : {1e-4, 5e-4, 2e-3}) probe.inputs.push_back({double(float(mu)), double(float(pixel))});
    return probe;
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "near the limb a pixel covers more of a body: of its ground, of its clouds, of the Sun") {
    const std::string ground =
        "check_known_body(1.0); return seen_surface(check_overhead, check_to_eye_at(mu), check_overhead, pixel).x;";
    const Probe probes[] = {
        slanting("", ground), slanting("#define BODY_STAR\n", ground),
        slanting(
            "",
            "check_known_body(6.4e6); float shell = body.radius + cloud_m; return seen_clouds(shell "
            "* check_overhead + 3e7 * check_to_eye_at(mu), -check_to_eye_at(mu), 1e30, check_overhead, pixel * shell "
            "/ 3e7).a;")};
    for (const Probe& probe : probes) CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
    // Beyond a cosine of 0.04 no more: the limb would be the mean of the whole map.
    Probe limb = slanting("", "return footprint_of(pixel, 2.0, mu);");
    limb.truth = [](auto in) { return Row{in[1] / 2 / 0.2}; };
    limb.inputs = {{double(0.04f), 0.5}, {double(0.02f), 0.5}, {0, 0.5}, {-0.5, 0.25}};
    CHECK(worst_of(limb, run_probe(gpu, limb, 1)) == "");
}

// The clouds' opacity is the share of a turn at which they are read; they take three quarters of the light at most.
TEST_CASE_METHOD(DeviceTest, "a cloud's shadow falls where the ray to the sun meets the clouds' sphere",
                 "[17.cloud_shadow]") {
    constexpr double radius = 6378e3, height = 9e3, turn = 2 * glm::pi<double>();
    Probe probe{
        .include = "common/srgb.glsl",
        .before = std::string(with_known_air) +
                  "#define MAP_BY_PLACE\n#include \"../tests/17_planets/known_body.glsl\"\n"
                  "#include \"17_planets/body.glsl\"\nfloat shadow(float across, float high) { "
                  "check_known_body(6378e3); return cloud_shadow(check_overhead, vec3(across, 0.0, high), 0.001); }\n",
        .signature = "float shadow(float across, float high)",
        .truth =
            [](auto in) {
                // The triangle of the centre, the place and the cloud: its sides are the two radii.
                const double elevation = std::atan2(in[1], in[0]);
                const double away = std::acos(std::cos(elevation) * radius / (radius + height)) - elevation;
                return Row{1 - 0.75 * (0.5 + away / turn)};
            },
        .bound = {.absolute = 3e-6},
        .macros = known_air(earth_air())};
    for (const double elevation : {90.0, 30.0, 10.0, 2.0, 0.5})
        probe.inputs.push_back(
            {double(float(std::cos(glm::radians(elevation)))), double(float(std::sin(glm::radians(elevation))))});
    CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
}

TEST_CASE_METHOD(DeviceTest,
                 "a pixel covers more of the rings the lower they are seen, along the ray and not across it",
                 "[17.ring_footprint]") {
    // A ray from 10 radii away, `high` above the rings, meets them at 2: towards the planet, or past it.
    const auto probe_of = [&](const std::string& eye, const std::string& way) {
        return Probe{.include = "common/srgb.glsl",
                     .before = std::string(with_known_air) +
                               "#define BODY_RINGS\n#include \"../tests/17_planets/known_body.glsl\"\n"
                               "#include \"../tests/17_planets/known_rings.glsl\"\n"
                               "#include \"17_planets/body.glsl\"\nfloat width(float high, float pixel) { "
                               "check_known_body(0.01); body.rings = Rings(1.0, 2.5, 1.0); body.to_body = mat3(1.0); "
                               "body.center = -" +
                               eye + "; body.to_sun = vec3(0.0, 1.0, 0.0); return seen_body(normalize(" + way +
                               "), pixel).a; }\n",
                     .signature = "float width(float high, float pixel)",
                     .inputs = {{0.25, 1e-4}, {1, 1e-4}, {4, 1e-3}},
                     .bound = {.relative = 0.01},
                     .macros = known_air(earth_air())};
    };
    Probe along = probe_of("vec3(0.0, high, 10.0)", "vec3(0.0, -high, -8.0)");
    along.truth = [](auto in) {  // the pixel's edges are followed to the rings
        const double angle = std::atan2(in[0], 8.0), half = 0.5 * in[1];
        return Row{in[0] / std::tan(angle - half) - in[0] / std::tan(angle + half)};
    };
    CHECK(worst_of(along, run_probe(gpu, along, 1)) == "");
    Probe across = probe_of("vec3(2.0, high, 8.0)", "vec3(0.0, -high, -8.0)");
    across.truth = [](auto in) { return Row{std::hypot(in[0], 8.0) * in[1]}; };
    CHECK(worst_of(across, run_probe(gpu, across, 1)) == "");
}
