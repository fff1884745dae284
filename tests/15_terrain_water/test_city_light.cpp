// How much of the sky walls and roofs of a city see, at every height.
#include "land_fixture.h"

using namespace lightwalk;

namespace {

struct Asked {
    glm::vec3 normal, on_wall;
    float sun_y;
};

}  // namespace

TEST_CASE_METHOD(
    OnDevice, "a roof sees the whole sky, a wall about half of it, and the street a third of that; no glass on roofs") {
    // A sun of irradiance 3 and a sky of 1, for any air; the sun stands along the normal or behind it.
    const Pipeline look = compute_pipeline("city light", R"(
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/view_path.glsl"
#define sunlight_on(place) vec3(3.0)
#define skylight_on(place) vec3(1.0)
#define path_from(position, direction, to_sun) Path(0.0, 0.0, 0.0, 0.0, 0.0)
float sun_left_on_wall(vec3 position, vec3 normal, vec3 to_sun, float height_m) { return 1.0; }
#include "15_terrain_water/city_light.glsl"
layout(local_size_x = 64) in;
struct Asked { vec3 normal, on_wall; float sun; };
layout(scalar) readonly buffer AskedBlock { Asked asked[]; };
layout(scalar) writeonly buffer FoundBlock { float found[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(asked.length()))
        found[i] = city_light_of(vec3(0.0), asked[i].normal, asked[i].on_wall, CITY_TOWER, 7u, 1.0, 1.0, asked[i].sun * asked[i].normal).g;
})");
    const auto found = [&](const std::vector<Asked>& asked) {
        const Buffer in = gpu.upload("asked", asked), out(gpu.device, {.name = "found", .bytes = 4 * asked.size()});
        frame.compute("look", {.reads = {in}, .writes = {out}}, [&](Compute& pass) {
            pass.use(look)
                .set("asked", in)
                .set("found", out)
                .set("city", 0.4f)
                .set("city_light", glm::vec2(0.0f, 1e-3f));
            pass.dispatch_threads(glm::uvec2(uint32_t(asked.size()), 1));
        });
        frame.end();
        const auto result = read<float>(out);
        frame.begin({4, 4}, 0);
        return result;
    };
    // Between windows: the sky's share follows from the sun's contribution.
    for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)})
        for (const float height : {0.2f, 3.35f, 31.0f, 60.0f}) {
            const auto light = found({{normal, {2.95f, height, 80}, 1}, {normal, {2.95f, height, 80}, -1}});
            const double open = 3 / (double(light[0]) / double(light[1]) - 1),
                         s = std::clamp(double(height) / 30, 0.0, 1.0);
            INFO("normal " << normal.x << " " << normal.y << " " << normal.z << " at " << height << " m");
            CHECK(open == Approx((normal.y > 0.5f ? 1.0 : 0.55) * (0.35 + 0.65 * s * s * (3 - 2 * s))).epsilon(0.002));
        }
    // A roof is the same everywhere; a wall has a window in the middle of its cell.
    const auto light = found({{{0, 1, 0}, {2.95f, 40, 80}, -1},
                              {{0, 1, 0}, {4.35f, 41.25f, 80}, -1},
                              {{1, 0, 0}, {2.95f, 40, 80}, -1},
                              {{1, 0, 0}, {4.35f, 41.25f, 80}, -1}});
    CHECK(double(light[0]) == Approx(0.17 / glm::pi<double>()).epsilon(0.002));
    CHECK(light[1] == light[0]);
    CHECK(light[3] != light[2]);
}
