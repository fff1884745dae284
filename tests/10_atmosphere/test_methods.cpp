// What the methods have in common: what gets through, views down, and the formula's own values.
#include "10_atmosphere/truth.h"
#include "atmosphere_fixture.h"
#include "common/check/probe.h"
#include "known_air.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnAtmosphere, "looking down from 3 km: light of the ground gets through as in double precision") {
    look({0, 3000, 0}, {0, 0, -1}, {0, 0, -1});
    size = {4, 4};
    camera.fov_y_rad = 0.02f;
    glm::dvec3 through;
    truth::in_scatter(
        atmosphere.air(), {3000, -1, 0.5f, -0.5f, 3000}, [](double) { return 0.08; }, 512, 8, &through);
    for (const std::string method : {"chapman", "march", "tables", "truth"}) {
        const glm::dvec3 bright = mean(picture(method, 2)), dark = mean(picture(method));
        INFO(method);
        for (int c = 0; c < 3; ++c) CHECK((bright[c] - dark[c]) / 2 == Approx(through[c]).epsilon(0.01));
    }
}

TEST_CASE_METHOD(OnAtmosphere, "looking down at an angle: the methods agree with the truth on what is scattered in") {
    atmosphere.steps.value = 32;
    atmosphere.light_steps.value = 32;
    for (const float height : {1000.0f, 10000.0f, 4e5f}) {
        look({0, height, 0}, {0, 0, -2 * height});
        camera.fov_y_rad = 0.3f;
        const ImageRgb right = picture("truth");
        for (const auto& [method, most] : {std::pair{"chapman", 0.03}, {"march", 0.03}, {"tables", 0.05}}) {
            INFO(method << " from " << height << " m");
            CHECK(relative_error(picture(method), right).mean < most);
        }
    }
}

TEST_CASE("Preetham's zenith is what his table says, and the sun's side is brighter") {
    Table inputs;
    for (const double t : {2.0, 3.0, 6.0})
        for (const double elevation : {10.0, 35.0, 60.0}) {
            const double e = elevation * truth::pi / 180;
            inputs.push_back({0, 1, 0, double(float(std::cos(e))), double(float(std::sin(e))), 0, t});
        }
    const Probe probe{.include = "10_atmosphere/preetham.glsl",
                      .signature = "vec3 preetham_xyY(vec3 direction, vec3 to_sun, float turbidity)",
                      .inputs = inputs,
                      .truth = {},
                      .bound = {},
                      .words = {},
                      .hint = {}};
    const Table found = run_probe(validated_device(), probe, 3);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const double t = inputs[i][6], s = std::acos(inputs[i][4]);
        const double luminance =
            (4.0453 * t - 4.9710) * std::tan((4.0 / 9 - t / 120) * (truth::pi - 2 * s)) - 0.2155 * t + 2.4192;
        const double x = (0.00166 * s * s * s - 0.00375 * s * s + 0.00209 * s) * t * t +
                         (-0.02903 * s * s * s + 0.06377 * s * s - 0.03202 * s + 0.00394) * t +
                         (0.11693 * s * s * s - 0.21196 * s * s + 0.06052 * s + 0.25886);
        CHECK(found[i][2] == Approx(luminance).epsilon(1e-3));
        CHECK(found[i][0] == Approx(x).epsilon(1e-3));
    }
    Probe around = probe;
    around.inputs = {{0.8, 0.6, 0, 0.8, 0.6, 0, 3}, {-0.8, 0.6, 0, 0.8, 0.6, 0, 3}};
    const Table sides = run_probe(validated_device(), around, 3);
    CHECK(sides[0][2] > 3 * sides[1][2]);
}
