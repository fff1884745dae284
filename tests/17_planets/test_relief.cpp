// Where the relief of a map of normals belongs, and where it does not.
#include "planets_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnPlanets, "relief tilts the Earth's land and leaves its water level") {
    planets.clouds.value = 0;
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
