// Random lights: made again only when the scene's lights, their number or the time change.
#include "../catch.h"
#include "03_attenuation/scattered_lights.h"

using namespace lightwalk;

TEST_CASE("scattered lights are one list for as long as nothing changes, and depend on nothing drawn before") {
    LightsWithScattered lights, others;
    const auto one = [](float intensity) {
        return std::make_shared<const std::vector<Light>>(1, Light{.kind = Light::Kind::point, .intensity = intensity});
    };
    LightList own = one(1);
    const Bounds where{glm::vec3(-4), glm::vec3(4)};
    const LightList first = lights.from(own, where, 100, 1);
    CHECK(first->size() == 101);
    CHECK(lights.from(own, where, 100, 1) == first);
    const LightList moved = lights.from(own, where, 100, 1, 2.5f);
    CHECK(moved != first);
    CHECK(lights.from(own, where, 100, 1, 2.5f) == moved);
    CHECK(*lights.from(own, where, 100, 1, 3.0f) != *moved);
    CHECK(*others.from(own, where, 100, 1, 2.5f) == *moved);
    CHECK(*lights.from(own, where, 100, 2) != *first);
    own = one(2);
    CHECK(lights.from(own, where, 100, 1)->at(0).intensity == 2);
    CHECK(lights.from(own, where, 99, 1)->size() == 100);
}
