// Kinds of shadow errors: the definition, case by case, and the truth around a point by rays.
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/shadow_data.h"
#include "05_shadow_maps/shadow_error.h"
#include "catch.h"
#include "common/scene_fixture.h"

using namespace lightwalk;

TEST_CASE("acne, peter-panning, leaks and edges are told apart by the truth around") {
    const ShadowTruth lit{1, 1, 1, -1}, dark{0, 0, 0, 5}, touched{0, 0, 0, 0.01f}, soft{0.5f, 0, 1, 5};
    const ShadowTruth lit_near_edge{1, 0, 1, -1}, dark_near_edge{0, 0, 1, 5}, gone{0, 0, 0, -1};
    const auto kind = [](float shown, const ShadowTruth& truth) { return shadow_error(shown, truth, 0.1f, 0.1f); };
    CHECK(kind(1.0f, lit) == SHADOW_RIGHT);
    CHECK(kind(0.91f, lit) == SHADOW_RIGHT);
    CHECK(kind(0.8f, lit) == SHADOW_ACNE);
    CHECK(kind(0.0f, lit) == SHADOW_ACNE);
    CHECK(kind(0.0f, lit_near_edge) == SHADOW_EDGE);
    CHECK(kind(0.0f, dark) == SHADOW_RIGHT);
    CHECK(kind(0.4f, dark) == SHADOW_LEAK);
    CHECK(kind(0.4f, touched) == SHADOW_PETER_PANNING);
    CHECK(kind(0.4f, dark_near_edge) == SHADOW_EDGE);
    CHECK(kind(1.0f, soft) == SHADOW_EDGE);
    CHECK(kind(0.0f, soft) == SHADOW_EDGE);
    CHECK(kind(0.55f, soft) == SHADOW_RIGHT);
    CHECK(kind(1.0f, gone) == SHADOW_LEAK);
}

namespace {

/// Over a floor of 20 m at z = 0, a board of 2 m at z = `board_m`, and a light along -z, tilted by `tilt` of x.
std::vector<ShadowTruth> truths(float board_m, float tilt, float radius_m, const std::vector<glm::vec3>& positions) {
    TestScene test({object_at(quad_file, {0, 0, 0}, glm::vec3(10.0f)), object_at(quad_file, {0, 0, board_m})});
    NoChapter chapter;
    Rays rays(chapter, "rays");
    rays.build(test.gpu, test.scene);
    const Pipeline pipeline = compute({.shader = "truths", .source = R"(
#include "05_shadow_maps/shadow_truth.glsl"
layout(local_size_x = 64) in;
layout(scalar) readonly buffer PositionBuffer { vec3 positions[]; };
layout(scalar) writeonly buffer ResultBuffer { ShadowTruth results[]; };
layout(scalar) uniform LightBlock { ShadowLight light; };
layout(scalar) uniform LookBlock { vec3 to_light; float radius_m; } look;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= positions.length()) return;
    rays_seed = seed_of(uvec2(i, 0u), 0u);
    results[i] = shadow_truth(light, positions[i], vec3(0.0, 0.0, 1.0), look.to_light, look.radius_m);
}
)"});
    ShadowLight light{};
    light.kind = LIGHT_DIRECTIONAL;
    light.views = 1;
    struct {
        glm::vec3 to_light;
        float radius_m;
    } const look{glm::normalize(glm::vec3(tilt, 0, 1)), radius_m};
    const Buffer in = test.gpu.upload("positions", positions);
    const Buffer out(test.gpu.device, {.name = "truths", .bytes = sizeof(ShadowTruth) * positions.size()});
    Frame frame(test.gpu);
    frame.begin({4, 4}, 0);
    rays.record(frame, test.scene);
    frame.compute("truths", {.writes = {out}, .with = {rays}}, [&](Compute& pass) {
        pass.use(pipeline).set("positions", in).set("results", out).set("light", light).set("look", look);
        pass.dispatch_threads(glm::uvec3(positions.size(), 1, 1));
    });
    frame.end();
    const auto bytes = test.gpu.read_back(out);
    std::vector<ShadowTruth> result(positions.size());
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
}

}  // namespace

TEST_CASE("the truth around a point is that of the surface's plane, as far as a filter reaches") {
    // Under the board's middle, 0.15 m inside its shadow's edge, as far outside of it, and far from it.
    const std::vector<glm::vec3> positions{{0, 0, 0}, {0.85f, 0, 0}, {1.15f, 0, 0}, {5, 0, 0}};
    for (const float radius_m : {0.1f, 0.3f}) {
        const auto found = truths(3, 0, radius_m, positions);
        const bool reaches = radius_m > 0.15f;
        for (size_t i = 0; i < found.size(); ++i) {
            INFO("radius " << radius_m << ", place " << i);
            const bool dark = i < 2;
            CHECK(found[i].visibility == (dark ? 0.0f : 1.0f));
            CHECK(found[i].least == (dark || (i == 2 && reaches) ? 0.0f : 1.0f));
            CHECK(found[i].most == (!dark || (i == 1 && reaches) ? 1.0f : 0.0f));
            CHECK(double(found[i].blocker_m) == Approx(dark ? 3.0 : -1.0).margin(1e-2));
        }
    }
}

TEST_CASE("a tilted light does not make a plane its own neighbour's shadow") {
    for (const float tilt : {0.0f, 1.0f, 10.0f, 50.0f}) {  // to 89 degrees
        const auto found = truths(-5, tilt, 0.05f, {{0, 0, 0}, {3, 1, 0}, {-2, 2, 0}});
        for (const ShadowTruth& truth : found) {
            CHECK(truth.visibility == 1.0f);
            CHECK(truth.least == 1.0f);
        }
    }
}
