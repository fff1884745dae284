// Common to the methods: transmittance, views down, and the formula's own values.
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/preetham.h"
#include "10_atmosphere/truth.h"
#include "atmosphere_fixture.h"
#include "common/check/probe.h"
#include "known_air.h"

using namespace lightwalk;

namespace {

/// x, y and Y (kcd/m²) as the paper's appendix A.2 has them: a row for each of Perez' A to E, for x, y and Y in turn.
glm::dvec3 preetham(glm::dvec3 direction, glm::dvec3 to_sun, double t) {
    constexpr double by_turbidity[3][5][2] = {
        {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}},
        {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}},
        {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}}};
    constexpr double zenith_of[2][3][4] = {{{0.00166, -0.00375, 0.00209, 0},
                                            {-0.02903, 0.06377, -0.03202, 0.00394},
                                            {0.11693, -0.21196, 0.06052, 0.25886}},
                                           {{0.00275, -0.00610, 0.00317, 0},
                                            {-0.04214, 0.08970, -0.04153, 0.00516},
                                            {0.15346, -0.26756, 0.06670, 0.26688}}};
    const double s = std::acos(to_sun.y), angle = std::acos(glm::dot(direction, to_sun));
    const auto perez = [&](int of, double cos_zenith, double from_sun) {
        double a[5];
        for (int i = 0; i < 5; ++i) a[i] = by_turbidity[of][i][0] * t + by_turbidity[of][i][1];
        return (1 + a[0] * std::exp(a[1] / cos_zenith)) *
               (1 + a[2] * std::exp(a[3] * from_sun) + a[4] * std::cos(from_sun) * std::cos(from_sun));
    };
    glm::dvec3 zenith(
        0, 0, (4.0453 * t - 4.9710) * std::tan((4.0 / 9 - t / 120) * (truth::pi - 2 * s)) - 0.2155 * t + 2.4192);
    for (int of = 0; of < 2; ++of)
        for (const auto& row : zenith_of[of])  // a polynomial of t with polynomials of s as coefficients
            zenith[of] = zenith[of] * t + ((row[0] * s + row[1]) * s + row[2]) * s + row[3];
    for (int of = 0; of < 3; ++of) zenith[of] *= perez(of, direction.y, angle) / perez(of, 1, s);
    return zenith;
}

}  // namespace

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

TEST_CASE("Preetham's sky is what his tables say, at its zenith and all around, and the sun's side is brighter") {
    Table inputs;
    for (const double t : {2.0, 3.0, 6.0, 10.0})
        for (const double elevation : {0.1, 0.6, 1.1})
            for (const auto& [up, turn] : {std::pair{1.57, 0.0}, {0.9, 0.3}, {0.4, 2.0}, {0.05, 3.1}})
                inputs.push_back({std::cos(up) * std::cos(turn), std::sin(up), std::cos(up) * std::sin(turn),
                                  std::cos(elevation), std::sin(elevation), 0, t});
    const Probe probe{.include = "10_atmosphere/preetham.glsl",
                      .signature = "vec3 preetham_xyY(vec3 direction, vec3 to_sun, float turbidity)",
                      .inputs = inputs};
    const Table found = run_probe(validated_device(), probe, 3);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const std::vector<double>& in = inputs[i];
        const glm::dvec3 right = preetham({in[0], in[1], in[2]}, {in[3], in[4], in[5]}, in[6]);
        INFO("turbidity " << in[6] << ", sun at " << std::asin(in[4]) << ", towards " << std::asin(in[1]));
        for (int c = 0; c < 3; ++c) CHECK(found[i][size_t(c)] == Approx(right[c]).epsilon(1e-3));
    }
    Probe around = probe;
    around.inputs = {{0.8, 0.6, 0, 0.8, 0.6, 0, 3}, {-0.8, 0.6, 0, 0.8, 0.6, 0, 3}};
    const Table sides = run_probe(validated_device(), around, 3);
    CHECK(sides[0][2] > 3 * sides[1][2]);
}

TEST_CASE_METHOD(OnAtmosphere,
                 "fog on a picture: as the formula says, down to its base and up without an end; none is none") {
    HeightFog fog{owner, "fog"};
    fog.density.value = 0.02f;
    fog.falloff.value = 0.05f;
    fog.color.value = fog.sun_color.value = glm::vec3(0);
    size = {4, 4};
    const auto through = [&](glm::vec3 from, glm::vec3 to) {
        look(from, to, {0, 0, -1});
        camera.fov_y_rad = 0.01f;
        frame.begin(size, 0);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(1.0f));
        lightwalk::draw(frame, view_of(camera, size), canvas, {fog});
        frame.end();
        return mean(read_linear(gpu, frame.hdr)).g;
    };
    CHECK(through({0, 40, 0}, {0, 0, 0}) == Approx(std::exp(-truth::fog_depth(0.02, 0.05, 40, -1, 40))).epsilon(2e-3));
    CHECK(through({0, 5, 0}, {0, 50, 0}) == Approx(std::exp(-0.02 / 0.05 * std::exp(-0.25))).epsilon(2e-3));
    fog.base_m.value = 20;
    CHECK(through({0, 40, 0}, {0, 0, 0}) == Approx(std::exp(-truth::fog_depth(0.02, 0.05, 20, -1, 20))).epsilon(2e-3));
    fog.start_m.value = 15;
    CHECK(through({0, 40, 0}, {0, 0, 0}) == Approx(std::exp(-truth::fog_depth(0.02, 0.05, 5, -1, 5))).epsilon(2e-3));
    fog.method.set("uniform");
    CHECK(through({0, 40, 0}, {0, 0, 0}) == Approx(std::exp(-0.02 * 5)).epsilon(2e-3));
    fog.method.set("none");
    CHECK(through({0, 40, 0}, {0, 0, 0}) == 1);
}
