// Where attenuation and culling fail: a bound where they hold, the size of the failure where they do not.
#include <cstring>

#include "03_attenuation/exercises.h"
#include "03_attenuation/lights.h"
#include "03_attenuation/truth.h"
#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

double evaluate(const std::string& file, const std::string& signature, Row arguments) {
    const Probe probe{.include = "03_attenuation/" + file + ".glsl", .signature = signature, .inputs = {arguments}};
    return run_probe(check_device(), probe, 1)[0][0];
}

double range_fade(double distance, double range, double k) {
    return evaluate("range_fade", "float range_fade(float distance, float range, float k)", {distance, range, k});
}

double window(double distance, double range) {
    return evaluate("inverse_square_window", "float inverse_square_window(float distance, float range)",
                    {distance, range});
}

double cone(double cosine, double cos_inner, double cos_outer, double softness) {
    return evaluate("spot_cone", "float spot_cone(float cosine, float cos_inner, float cos_outer, float softness)",
                    {cosine, cos_inner, cos_outer, softness});
}

}  // namespace

TEST_CASE("a range of 0 lights nothing, at distance 0 either, and gives no NaN") {
    for (const double distance : {0.0, 1e-30, 1.0}) {
        CHECK(range_fade(distance, 0, 1) == 0);
        CHECK(window(distance, 0) == 0);
    }
    CHECK(range_fade(0, 5, 1) == 1);
    CHECK(window(0, 5) == 1);
}

TEST_CASE("what is zero outside the range is zero to the last bit, whatever it is multiplied by") {
    for (const double range : {1e-3, 1.0, 7.3, 1e6})
        for (const double beyond : {1.0, 1.0000002, 2.0, 1e9}) {
            CHECK(range_fade(range * beyond, range, 1) == 0);
            CHECK(window(range * beyond, range) == 0);
        }
}

TEST_CASE(
    "the window keeps 88, 47 and 12 percent at 0.5, 0.75 and 0.9 of the range; the added 1 halves the light at 1 m") {
    const auto kept = [](double share) {
        return truth::inverse_square_window(100 * share, 100) * (1e4 * share * share + 1);
    };
    CHECK(kept(0.5) == Approx(0.879).margin(0.0005));
    CHECK(kept(0.75) == Approx(0.467).margin(0.0005));
    CHECK(kept(0.9) == Approx(0.118).margin(0.0005));
    CHECK(window(1, 1000) == Approx(0.5).margin(1e-6));
}

TEST_CASE("equal inner and outer angles are a hard edge, not a division by 0") {
    for (const double edge : {-1.0, -0.5, 0.0, 0.7, 0.9999}) {
        CHECK(cone(edge + 2e-4 * (edge < 0.9 ? 1 : 0.3), edge, edge, 0.5) == 1);
        CHECK(cone(edge - 2e-4, edge, edge, 0.5) == 0);
        CHECK(std::isfinite(cone(edge, edge, edge, 0.5)));
    }
    CHECK(std::isfinite(cone(1, 1, 1, 1)));
    CHECK(cone(0.5, 0.9, 0.8, 1) == 0);  // a power of 0
}

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

TEST_CASE("the error of culling is up to the number of lights times the threshold: 1,000 that each just miss are 3.9") {
    const double threshold = 1.0 / 256, radius = std::sqrt(100 / threshold);
    double lost = 0;
    for (int i = 0; i < 1000; ++i) lost += 100 / std::pow(radius * 1.0001, 2);
    CHECK(lost > 0.999 * 1000 * threshold);
    CHECK(lost <= 1000 * threshold);
    CHECK(lost == Approx(3.905).margin(0.002));  // where white is 1
}

TEST_CASE("a sum of floats depends on its order: lists that are not in the lights' order change the picture") {
    const auto sum = [](int first, int step) {
        float total = 0;
        for (int i = first; i >= 0 && i < 1000; i += step) total += 1.0f / (1.0f + static_cast<float>(i * i));
        return total;
    };
    CHECK(sum(0, 1) != sum(999, -1));
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

TEST_CASE("no object loses light: nothing in a box that is refused is lit") {
    Random random;
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        Light light{
            .kind = i % 2 ? Light::Kind::point : Light::Kind::spot, .direction = random.direction(), .range_m = 5};
        light.position = 4.0f * random.direction();
        light.outer_rad = light.inner_rad = static_cast<float>(random.uniform(0, 3.14));
        Bounds box;
        const glm::vec3 corner = 3.0f * random.direction();
        box.add(corner);
        box.add(corner + glm::abs(random.direction()));
        if (light_reaches_box(light, light.range_m, box)) continue;
        ++refused;
        for (int k = 0; k < 50; ++k) {
            const glm::dvec3 at =
                glm::mix(glm::dvec3(box.lower), glm::dvec3(box.upper),
                         glm::dvec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)));
            const glm::dvec3 way = at - glm::dvec3(light.position);
            const double cosine = glm::dot(glm::normalize(way), glm::dvec3(light.direction));
            const bool lit = glm::length(way) < 5 && (light.kind == Light::Kind::point ||
                                                      cosine > std::cos(static_cast<double>(light.outer_rad)));
            if (lit) FAIL("light is lost");
        }
    }
    CHECK(refused > 300);
}
