// Paths with too many iterations for one dispatch: no light is lost.
#include <fmt/core.h>

#include "10_atmosphere/atmosphere.h"
#include "10_atmosphere/truth.h"
#include "atmosphere_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnAtmosphere, "more places on the way keep the truth's light, and the march's, from 10 km",
                 "[figures][10.more_places]") {
    size = {4, 4};
    camera.fov_y_rad = 0.002f;
    atmosphere.sun_elevation_deg.value = 12;
    for (const float down : {0.0f, 0.04f, 0.3f}) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(0, -double(down), -1)), sun(atmosphere.to_sun());
        look({0, 1e4f, 0}, {0, 1e4f - 1e4f * down, -1e4f});
        const Air air = atmosphere.air();
        const double radius = double(air.radius);
        const glm::dvec2 ground = truth::ray_sphere(1e4, direction.y, radius, 0);
        const double way =
            ground.x < ground.y ? ground.x : truth::ray_sphere(1e4, direction.y, radius, double(air.top)).y;
        const auto dust = [&](double c) { return truth::phase_cornette_shanks(c, double(air.mie_g)); };
        const glm::dvec3 right = truth::in_scatter(
            air, {1e4f, float(direction.y), float(sun.y), float(glm::dot(direction, sun)), float(way)}, dust, 4096, 96);
        const auto off = [&](const std::string& method, int steps, int light_steps) {
            atmosphere.steps.value = steps;
            atmosphere.light_steps.value = light_steps;
            const glm::dvec3 found = mean(picture(method));
            double most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::fabs(found[c] / right[c] - 1));
            fmt::print("{} with {} steps from 10 km, {} down: light off by at most {:.2f}%\n", method, steps, down,
                       100 * most);
            return most;
        };
        for (const int steps : {16, 48, 128, 1000}) CHECK(off("truth", steps, 8) < 0.005);
        CHECK(off("march", 1000, 256) < 0.005);
    }
}

TEST_CASE_METHOD(OnAtmosphere,
                 "parts of a path: none turns too often, all there is is in one of them, and none is refused "
                 "that can be done") {
    const Air air = atmosphere.air();
    CHECK(path_parts({.places = 512, .light_places = 48, .walks = 16}, air).size() == 1);
    const auto parts = path_parts({.places = 32 * 4096, .light_places = 48, .walks = 512}, air);
    int walks = 0, places = 0;
    for (const PathPart& part : parts) {
        CHECK(part.first_walk == (part.end_walk > 0 ? walks : 0));
        CHECK(part.first_place == (part.end_place > 0 ? places : 0));
        walks += part.end_walk - part.first_walk;
        places += part.end_place - part.first_place;
        CHECK((part.end_place - part.first_place) * 50 <= 65535);
        CHECK(part.begins == (&part == &parts.front()));
        CHECK(part.ends == (&part == &parts.back()));
    }
    CHECK(walks == 512);
    CHECK(places == 32 * 4096);
    atmosphere.rayleigh.value = glm::vec3(1000);
    CHECK_THROWS_AS(path_parts({.walks = 1}, atmosphere.air()), InputError);
    CHECK_NOTHROW(path_parts({.places = 512, .light_places = 48}, atmosphere.air()));
}
