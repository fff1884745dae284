// Each object's lights where the objects move.
#include <algorithm>

#include "03_attenuation/lights.h"
#include "catch.h"
#include "common/scene_fixture.h"

using namespace lightwalk;

TEST_CASE("an object that has moved away from a light has another list") {
    SceneObject object = object_at(quad_file, {0, 0, 0});
    object.motion.path = {{.time_s = 0}, {.time_s = 1, .position = {9, 0, 0}}};
    TestScene test({object});
    LightBuffer lights;
    Frame frame(test.gpu);
    const auto recorded = [&](const auto& record) {
        frame.begin({4, 4}, 0);
        record();
        frame.end();
    };
    recorded([&] { lights.update(frame, {{.kind = Light::Kind::point, .position = {0, 0, 1}, .range_m = 2}}); });
    ObjectLights lists;
    const auto reaching = [&](float time_s) {
        animate(test.scene, time_s);
        recorded([&] { lists.update(frame, test.scene, lights, 0); });
        uint32_t end = 0;
        std::memcpy(&end, test.gpu.read_back(lists.ends).data(), 4);
        return end;
    };
    CHECK(reaching(0) == 1);
    CHECK(reaching(1) == 0);
    CHECK(reaching(0) == 1);
    // An inverse square that never ends: how far it is taken to reach follows the threshold.
    animate(test.scene, 1);
    const auto reaching_above = [&](float threshold) {
        recorded([&] { lists.update(frame, test.scene, lights, threshold); });
        uint32_t end = 0;
        std::memcpy(&end, test.gpu.read_back(lists.ends).data(), 4);
        return end;
    };
    CHECK(reaching_above(0.001f) == 1);  // 32 m
    CHECK(reaching_above(0.5f) == 0);    // 1.4 m
    CHECK(reaching(0) == 1);
}

// Lights 1 m above the floor, 4 m apart, reach 2 m: 1.73 m on the floor, so that no point has two of them.
TEST_CASE("a large floor has every light in its list, though each point is reached by one at most",
          "[03.large_object]") {
    TestScene test({object_at(quad_file, {0, 0, 0}, {20, 20, 1})});
    std::vector<Light> all;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            all.push_back({.kind = Light::Kind::point, .position = {4 * x - 18, 4 * y - 18, 1}, .range_m = 2});
    int most = 0;
    for (double y = -20; y <= 20; y += 0.25)
        for (double x = -20; x <= 20; x += 0.25) {
            int reaching = 0;
            for (const Light& light : all)
                reaching += glm::distance(glm::dvec3(light.position), glm::dvec3(x, y, 0)) < double(light.range_m);
            most = std::max(most, reaching);
        }
    CHECK(most == 1);
    LightBuffer lights;
    ObjectLights lists;
    Frame frame(test.gpu);
    frame.begin({4, 4}, 0);
    lights.update(frame, all);
    lists.update(frame, test.scene, lights, 0);
    frame.end();
    uint32_t end = 0;
    std::memcpy(&end, test.gpu.read_back(lists.ends).data(), 4);
    CHECK(end == 100);
}
