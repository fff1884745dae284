// Where rays from a surface begin, as the rasteriser gives it: far enough above it that it does not shadow itself.
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "05_shadow_maps/rays.h"
#include "catch.h"
#include "common/scene_fixture.h"

using namespace lightwalk;

namespace {

struct Seen {
    int largest_power = -100;  ///< of two: the offset that was needed, in the scene's farthest coordinate
    int pixels = 0, self_hits = 0;
};

// A plane of 64 m, turned and far from the origin, and the eye low above it.
Seen look(glm::vec3 rotation_deg, glm::vec3 position, float height_m) {
    Gpu& gpu = check_device();
    SceneObject ground = object_at(quad_file, position, glm::vec3(32.0f));
    ground.rotation_deg = rotation_deg;
    TestScene test({ground});
    NoChapter chapter;
    Rays rays(chapter, "rays");
    rays.build(gpu, test.scene);
    const Pipeline pipeline = graphics({.vertex = "03_attenuation/surface.vert",
                                        .fragment = "../tests/05_shadow_maps/data/self_hit.frag",
                                        .cull = VK_CULL_MODE_NONE,
                                        .macros = {{"RAYS_SOLID", "1"}}});
    const glm::mat3 turn(test.scene.items[0].transform);
    const glm::vec3 up = glm::normalize(turn[2]), along = glm::normalize(turn[0] + 0.3f * turn[1]);
    const glm::vec3 eye = position + height_m * up;
    Frame frame(gpu);
    frame.begin({160, 90}, 0);
    const CameraView view{.view_projection = glm::perspective(1.0f, 16.0f / 9.0f, 100.0f, 0.01f) *
                                             glm::lookAt(eye, eye + along - 0.2f * up, up),
                          .eye = eye,
                          .time_s = 0,
                          .size = frame.size,
                          .seed = 0};
    const auto bytes = std::as_bytes(std::span(&view, 1));
    frame.globals["view"].assign(bytes.begin(), bytes.end());
    rays.record(frame, test.scene);
    const float farthest = rays.offset_m() / Rays::offset_share;
    frame.raster("look", {.color = {clear(frame.hdr, glm::vec4(0.0f))}, .depth = frame.depth, .with = {rays}},
                 [&](Raster& pass) { pass.use(pipeline).set("farthest_m", farthest).draw(test.scene); });
    frame.end();
    Seen seen;
    const auto texels = gpu.read_back(frame.hdr);
    for (size_t at = 0; at < texels.size(); at += 8) {
        uint64_t texel = 0;
        std::memcpy(&texel, &texels[at], 8);
        const glm::vec4 color = glm::unpackHalf4x16(texel);
        if (color.b == 0.0f) continue;
        ++seen.pixels;
        seen.self_hits += color.g != 0.0f;
        seen.largest_power = std::max(seen.largest_power, static_cast<int>(-color.r));
    }
    return seen;
}

}  // namespace

TEST_CASE("a flat surface does not shadow itself, wherever it is and from wherever it is seen") {
    Random random;
    int largest = -100, pixels = 0, self_hits = 0;
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 turn(random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180));
        const glm::vec3 at = (i % 3 == 0 ? 0.0f : i % 3 == 1 ? 10.0f : 100.0f) * random.direction();
        const Seen seen = look(turn, at, i % 2 ? 0.2f : 5.0f);
        largest = std::max(largest, seen.largest_power);
        pixels += seen.pixels;
        self_hits += seen.self_hits;
    }
    WARN(pixels << " pixels; rays of all are free from 2^" << largest << " of the farthest coordinate on");
    CHECK(pixels > 50000);
    CHECK(self_hits == 0);
    CHECK(std::exp2(float(largest + 2)) <= Rays::offset_share);
}
