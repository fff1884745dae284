// The tables' missing light, compared with the truth's, with all orders of scattering, over heights, suns and
// directions.
#include <fmt/core.h>

#include "atmosphere_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnAtmosphere, "tables over heights, suns and directions: within 5% of random walks in each channel",
                 "[figures][10.tables]") {
    size = {12, 8};
    camera.fov_y_rad = 1.0f;
    const auto around = [&](const std::string& method, float height) {
        glm::dvec3 sum(0);
        for (const glm::vec3 to :
             {glm::vec3(0.5f, 0.35f, -1), {1, 0.35f, 0.3f}, {-0.2f, 0.6f, 1}, {-1, -0.3f, -0.3f}}) {
            look({0, height, 0}, glm::vec3(0, height, 0) + 1000.0f * to);
            sum += mean(picture(method));
        }
        return sum;
    };
    atmosphere.paths.value = 128;
    for (const float height : {2.0f, 10000.0f, 60000.0f})
        for (const float elevation : {3.0f, 12.0f, 40.0f}) {
            atmosphere.sun_elevation_deg.value = elevation;
            const auto off = [&](const char* orders) {
                atmosphere.orders.set(orders);
                return around("tables", height) / around("truth", height) - 1.0;
            };
            const glm::dvec3 once = off("single"), often = off("multiple");
            fmt::print(
                "tables at {:5} m, sun at {:2}: red, green, blue scattered once {:+.1f} {:+.1f} {:+.1f}%, all orders "
                "{:+.1f} {:+.1f} {:+.1f}%\n",
                height, elevation, 100 * once.r, 100 * once.g, 100 * once.b, 100 * often.r, 100 * often.g,
                100 * often.b);
            INFO(height << " m, sun at " << elevation);
            for (int c = 0; c < 3; ++c) {
                CHECK(std::fabs(once[c]) < (height > 5e4f ? 0.03 : 0.006));
                CHECK(std::fabs(often[c]) < 0.055);
            }
        }
}
