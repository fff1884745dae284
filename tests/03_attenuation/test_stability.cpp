// Where attenuation and culling fail: a bound where they hold, the size of the failure where they do not.
#include "03_attenuation/exercises.h"
#include "03_attenuation/lights.h"
#include "03_attenuation/truth.h"
#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

double cone(double cosine, double cos_inner, double cos_outer, double softness) {
    const Probe probe{.include = "03_attenuation/spot_cone.glsl",
                      .signature = "float spot_cone(float cosine, float cos_inner, float cos_outer, float softness)",
                      .inputs = {{cosine, cos_inner, cos_outer, softness}}};
    return run_probe(check_device(), probe, 1)[0][0];
}

}  // namespace

TEST_CASE("softness 1 gives 57 percent of full light a fifth into the edge, where a linear edge gives 20",
          "[03.softness]") {
    CHECK(cone(0.82, 0.9, 0.8, 0) == Approx(0.2).margin(2e-5));
    CHECK(cone(0.82, 0.9, 0.8, 1) == Approx(std::pow(0.2, 0.35)).margin(5e-5));
    CHECK(std::pow(0.2, 0.35) == Approx(0.57).margin(0.005));
}

TEST_CASE("an infinite falloff is culled far away: an intensity of 100 down to 1/256 at 160 m",
          "[03.infinite_falloff]") {
    LightData light = pack({.kind = Light::Kind::point, .color = glm::vec3(0.2f, 1.0f, 0.5f), .intensity = 100});
    CHECK(influence_radius(light, 1.0f / 256) == Approx(160));
    CHECK(influence_radius(light, 0) == light.range);
    light.radiance = {0, 0, 0};
    CHECK(influence_radius(light, 1.0f / 256) == 0);
}

TEST_CASE("a cone meets a ball: cones of every angle, balls all around, also behind the apex", "[03.cone_meets_ball]") {
    Probe probe{.include = "03_attenuation/cell.glsl",
                .signature = "bool cone_reaches_ball(vec3 center, float radius, vec3 axis, float cos_outer)"};
    std::vector<double> misses;
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 center = static_cast<float>(random.logarithmic(0.1, 30)) * random.direction();
        const glm::vec3 axis = i % 7 ? random.direction() : glm::normalize(center) * (i % 2 ? 1.0f : -1.0f);
        const double radius = random.logarithmic(0.01, 10), angle = i % 5 ? random.uniform(0, 3.14) : 0.5 * (i % 3);
        Row row;
        append(row, center);
        row.push_back(radius);
        append(row, axis);
        row.push_back(static_cast<float>(std::cos(angle)));
        probe.inputs.push_back(row);
        const double exact = std::acos(static_cast<double>(static_cast<float>(std::cos(angle))));
        misses.push_back(truth::distance_to_cone(center, glm::dvec3(0.0), glm::normalize(glm::dvec3(axis)), exact) -
                         radius);
    }
    const Table results = run_probe(check_device(), probe, 1);
    int lost = 0, needless = 0, reached = 0;
    for (size_t i = 0; i < misses.size(); ++i) {
        const bool says = results[i][0] != 0;
        reached += says;
        if (!says && misses[i] < -1e-3) ++lost;
        if (says && misses[i] > 1e-3 * 30) ++needless;
    }
    CHECK(lost == 0);
    CHECK(needless == 0);
    CHECK(reached > 5000);
    CHECK(reached < 18000);
}
