// The table of the sky's light: made for an air, scaled for its sun.
#include "../catch.h"
#include "10_atmosphere/skylight.h"

using namespace lightwalk;

TEST_CASE("sunlight and exposure scale the sky's table; only another air makes it again") {
    Air air{.rayleigh = {5.8e-6f, 13.6e-6f, 33.1e-6f},
            .rayleigh_height = 8000,
            .mie = glm::vec3(4e-6f),
            .mie_height = 1200,
            .mie_extinction = glm::vec3(4.4e-6f),
            .mie_g = 0.8f,
            .radius = 6.36e6f,
            .top = 1e5f,
            .sun = glm::vec3(1.0f),
            .sun_rad = 0.005f};
    SkylightTable table, afresh;
    CHECK(table.follow(air));
    const std::vector<glm::vec3> unit = table.entries();
    for (const float sun : {0.37f, 12.8f, 1.0f}) {
        air.sun = sun * glm::vec3(1.0f, 0.9f, 0.7f);
        CHECK(table.follow(air));
        CHECK_FALSE(table.follow(air));
        for (size_t i = 0; i < unit.size(); ++i)
            for (int c = 0; c < 3; ++c) CHECK(table.entries()[i][c] == Approx(unit[i][c] * air.sun[c]).epsilon(1e-6));
    }
    CHECK(table.made == 1);
    air.sun_rad = 0.01f;  // a wider sun of the same light
    CHECK_FALSE(table.follow(air));
    air.mie_height = 800;
    CHECK(table.follow(air));
    CHECK(table.made == 2);
    CHECK(afresh.follow(air));  // whatever came before
    CHECK(afresh.entries() == table.entries());
}
