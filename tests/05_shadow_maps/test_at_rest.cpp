// Shadows of a scene at rest: what was found for the frame before is used again, and only that.
#include <functional>

#include "shadow_fixture.h"

using namespace lightwalk;

TEST_CASE("casters are searched again where a light, the camera, an object or a knob has changed, and only there") {
    SceneObject ball = object_at(ball_file, {0.5f, 0, 1}, glm::vec3(0.4f));
    ball.motion.path = {{.time_s = 0, .position = ball.position, .scale = ball.scale},
                        {.time_s = 1, .position = {-0.7f, 0.3f, 0.8f}, .scale = ball.scale}};
    const std::vector<SceneObject> objects{object_at(quad_file, {0, 0, 0}, glm::vec3(9.0f)), ball,
                                           object_at(ball_file, {-1, 1, 0.6f}, glm::vec3(0.3f))};
    const std::vector<Light> both{sun_at(30), {.kind = Light::Kind::point, .position = {0.5f, -1, 3}}};
    std::vector<TestPoint> points = square(2000, 2.0f);
    for (size_t i = 0; i < points.size(); i += 2) points[i].light = 1;

    std::vector<std::function<void(ShadowScene&)>> changes{
        [](ShadowScene& test) { test.scene.file.lights[1].position.x = -1; },
        [](ShadowScene& test) { test.scene.file.lights[0].direction = sun_at(50).direction; },
        [](ShadowScene& test) { test.scene.file.lights[1].shadow = false; },
        [](ShadowScene& test) {
            test.camera.position = {1, 1, 6};
        },
        [](ShadowScene& test) { animate(test.scene, 0.7f); }};
    for (const auto& [knob, value] :
         {std::pair{"cascades", "2"}, {"resolution", "128"}, {"distance_m", "8"}, {"split", "0.9"}, {"near_m", "0.3"}})
        changes.push_back([knob = knob, value = value](ShadowScene& test) { test.set({{knob, value}}); });

    ShadowScene test(objects, both);
    test.visibility(points);
    for (size_t i = 0; i < changes.size(); ++i) {
        INFO("change " << i);
        const int before = test.shadow.searches;
        test.visibility(points);
        CHECK(test.shadow.searches == before);
        changes[i](test);
        const std::vector<float> now = test.visibility(points);
        CHECK(test.shadow.searches == before + 1);
        ShadowScene fresh(objects, both);
        for (size_t k = 0; k <= i; ++k) changes[k](fresh);
        CHECK(now == fresh.visibility(points));
    }
}

TEST_CASE("lights that need more maps than the device has are refused in every frame, not in the first alone",
          "[05.too_many]") {
    ShadowScene test(
        {object_at(quad_file, {0, 0, 0}, glm::vec3(9.0f)), object_at(ball_file, {0, 0, 1}, glm::vec3(0.5f))},
        {sun_at(30)});
    const std::vector<TestPoint> points = square(400, 2.0f);
    const std::vector<float> before = test.visibility(points);
    for (int i = 0; i < 3; ++i) test.visibility(points);  // every map is there
    const size_t faces = 6, most = test.gpu.device.properties.limits.maxImageArrayLayers;
    const Light within{.kind = Light::Kind::point, .position = {0, 0, 1}, .shadow = true};
    test.scene.file.lights.insert(test.scene.file.lights.end(), most / faces + 1, within);
    for (int i = 0; i < 3; ++i)
        CHECK_THROWS_WITH(test.visibility(points), Catch::Matchers::Contains("this device has at most"));
    test.scene.file.lights.resize(1);
    CHECK(test.visibility(points) == before);
}
