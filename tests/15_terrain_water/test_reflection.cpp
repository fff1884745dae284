// Reflections in waves against rays: from each pixel to the water, and from there to the reflected point.
#include <fmt/core.h>

#include <cmath>

#include "transparency_fixture.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

// The water that a ray from above meets: where it has moved to, and its normal.
struct Met {
    glm::dvec3 place, normal;
};
Met met_by(const std::vector<WaveData>& waves, glm::dvec3 eye, glm::dvec3 along) {
    glm::dvec2 rest(0);
    double height = 0;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 level = eye + (height - eye.y) / along.y * along;
        const glm::dvec3 moved = i ? moved_by(waves, rest) : glm::dvec3(0);
        const glm::dvec2 now = i ? rest + glm::dvec2(moved.x, moved.z) : glm::dvec2(level.x, level.z);
        rest = i ? rest + 0.6 * (glm::dvec2(level.x, level.z) - now) : now;
        height = moved_by(waves, rest).y;
    }
    glm::dmat3 slopes(0.0);
    for (const WaveData& w : waves)
        slopes +=
            truth::gerstner_slopes(rest, glm::dvec2(w.k), double(w.amplitude), double(w.steepness), double(w.phase));
    return {glm::dvec3(rest.x, 0, rest.y) + moved_by(waves, rest), truth::normal_of(slopes)};
}

}  // namespace

TEST_CASE_METHOD(OnWater, "reflections of a wall in waves, by each method, against rays", "[15.wall]") {
    water.waves.value = 4;
    water.longest_m.value = 14;
    water.shortest_m.value = 7;
    water.roughness.value = 0;
    water.refraction.value = 0;
    water.mirror.scale.value = 1;
    camera.position = {0, 6, 0};
    camera.target = {-2, 0.5f, -24};
    const View view = view_of(camera, size);
    const ViewRays rays = view_rays(view);
    // By steepness, and by how far away the wall is.
    for (const float slope : {0.005f, 0.02f, 0.05f})
        for (const float away : {40.0f, 400.0f}) {
            water.slope.value = slope;
            Wall wall(owner);
            const float wide = away / 40;
            wall.z = -away;
            wall.left = -12 * wide;
            wall.right = 4 * wide;
            wall.top = 9 * wide;
            wall.bottom = -0.5f;
            water.method.set("gerstner");
            const std::vector<WaveData> waves = water.waves_at(1.5);
            std::vector<double> right(size_t(size.x) * size.y, -1);
            double all = 0;
            for (uint32_t y = 0; y < size.y; ++y)
                for (uint32_t x = 0; x < size.x; ++x) {
                    const glm::dvec3 along = glm::normalize(glm::dvec3(ray_through(rays, glm::vec2(x, y) + 0.5f)));
                    const double to_level = -double(camera.position.y) / along.y;
                    if (along.y > -0.05 || to_level * -along.z > double(away) - 8)
                        continue;  // near the horizon, or past the wall
                    const Met met = met_by(waves, glm::dvec3(camera.position), along);
                    const glm::dvec3 mirrored = glm::reflect(along, met.normal);
                    const double t = (double(wall.z) - met.place.z) / mirrored.z;
                    const glm::dvec3 hit = met.place + t * mirrored;
                    const bool shows = t > 0 && hit.x > double(wall.left) && hit.x < double(wall.right) &&
                                       hit.y < double(wall.top) && hit.y > double(wall.bottom);
                    const double share = truth::fresnel_water(glm::dot(met.normal, -along), 1, 1.333);
                    right[size_t(y) * size.x + x] = shows ? 4 * share : 0;
                    all += right[size_t(y) * size.x + x];
                }
            REQUIRE(all > 5);
            std::map<std::string, double> off;
            for (const char* method : {"cube", "screen_space", "planar"}) {
                const ImageRgb with = picture("gerstner", method, 1.5f, {wall}),
                               without = picture("gerstner", method, 1.5f);
                double sum = 0;
                for (size_t i = 0; i < right.size(); ++i)
                    if (right[i] >= 0)
                        sum += std::fabs(double(with.pixels[i].r) - double(without.pixels[i].r) - right[i]);
                off[method] = sum / all;
            }
            fmt::print(
                "slope {}, wall {} m away: light of its reflection wrong by {:.0f}% cube, {:.0f}% screen_space, "
                "{:.0f}% planar\n",
                slope, away, 100 * off["cube"], 100 * off["screen_space"], 100 * off["planar"]);
            CHECK(off["cube"] > 0.9);                              // which holds the sky alone
            CHECK(off["planar"] < (slope < 0.03f ? 0.08 : 0.27));  // a level mirror, shifted by the normal
            CHECK(off["screen_space"] < (away < 100 ? 0.15 : 0.5));
            if (slope < 0.03f) CHECK(off["planar"] < off["screen_space"]);
        }
}

TEST_CASE_METHOD(OnWater, "a transparent surface is seen in the mirror before the sky") {
    struct : Wall {
        using Wall::Wall;
        Phase draw_phase() const override { return Phase::sky; }
    } sky(owner);
    sky.left = -9000;
    sky.right = 9000;
    sky.bottom = -1;
    sky.top = 9000;
    sky.z = -3000;
    sky.color = {0, 2, 0, 1};
    Quads smoke(owner, "smoke");
    smoke.quads = {{{{-9, 1, -40}, {9, 1, -40}, {9, 8, -40}, {-9, 8, -40}}, {0, 0, 4, 0.5f}}};
    water.mirror.scale.value = 1;
    const auto middle = [&](Drawings all) {
        water.method.set("flat");
        water.reflection.set("planar");
        begin(size);
        const View view = view_of(camera, size);
        light.record(frame, scene);
        all.push_back(sky);
        water.reflect(frame, view, all);
        Canvas canvas(frame.hdr, frame.depth, background);
        lightwalk::draw(frame, view, canvas, {water});
        frame.end();
        const ImageRgb seen = read_linear(gpu, frame.hdr);
        const glm::vec4 clip = view.view_projection * glm::vec4(0, -4.5f, -40, 1);  // of the pane's mirror image
        const glm::uvec2 p((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(size));
        return seen.pixels[p.y * size.x + p.x];
    };
    const glm::vec3 without = middle({}), with = middle({smoke});
    // Half of the sky is hidden, and half of the pane's own light takes its place: 2 for each 1 that goes.
    CHECK(without.g - with.g > 0.05f);
    CHECK(double((with.b - without.b) / (without.g - with.g)) == Approx(2).epsilon(0.05));
}
