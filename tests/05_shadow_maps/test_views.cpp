// Light views: cascades that stand still, cubes without seams, and maps that are drawn only where they have to be.
#include "shadow_fixture.h"

using namespace lightwalk;

namespace {

// How many of the points' visibilities change, on average over steps of a tenth of a texel of the camera.
double changes(bool snap) {
    std::vector<SceneObject> objects{object_at(quad_file, {0, 0, 0}, glm::vec3(40.0f))};
    for (int i = 0; i < 8; ++i)
        objects.push_back(object_at(ball_file, {float(i % 4) - 1.5f, float(i / 4) - 0.5f, 0.5f}, glm::vec3(0.3f)));
    ShadowScene test(objects, {sun_at(50, 30)});
    test.set({{"cascades", "3"},
              {"distance_m", "20"},
              {"resolution", "256"},
              {"slope", "1"},
              {"snap", snap ? "on" : "off"}});
    const std::vector<TestPoint> points = square(20000, 2.0f);
    std::vector<float> before = test.visibility(points);
    const LightViewOptions options{256, 0.05f, 3, 0.7f, 20, snap};
    const float texel = light_views(sun_at(50, 30), 10, test.scene.bounds, test.camera, options).front().data.texel;
    double changed = 0;
    for (int step = 0; step < 20; ++step) {
        test.camera.position.x += 0.1f * texel;
        test.camera.target.x += 0.1f * texel;
        const std::vector<float> now = test.visibility(points);
        for (size_t i = 0; i < now.size(); ++i) changed += now[i] != before[i];
        before = now;
    }
    return changed / 20;
}

}  // namespace

TEST_CASE("a camera that moves by tenths of a texel changes no shadow where cascades are snapped to texels",
          "[05.snapped]") {
    const double snapped = changes(true), loose = changes(false);
    INFO("of 20,000 points " << snapped << " a step with, " << loose << " without");
    CHECK(snapped <= 2);  // points at the edge between two cascades
    CHECK(loose > 50);
}

TEST_CASE("turning the camera leaves the size of cascades as it is") {
    const Bounds large{glm::vec3(-100.0f), glm::vec3(100.0f)};
    Camera camera{.position = {1, 2, 3}, .target = {4, 2, 1}, .near_m = 0.1f};
    const LightViewOptions options{512, 0.05f, 4, 0.7f, 60, true};
    const auto before = light_views(sun_at(40), 0, large, camera, options);
    REQUIRE(before.size() == 4);
    for (const glm::vec3 target : {glm::vec3(-4, 3, 3), glm::vec3(1, -9, 3.5f), glm::vec3(2, 2, 9)}) {
        camera.target = target;
        const auto now = light_views(sun_at(40), 0, large, camera, options);
        for (size_t i = 0; i < 4; ++i) CHECK(now[i].data.texel == Approx(before[i].data.texel).epsilon(1e-5));
    }
}

TEST_CASE("cascades hold all that the camera sees as far as they reach, and a small scene is one map") {
    const Bounds large{glm::vec3(-100.0f), glm::vec3(100.0f)};
    const Camera camera{.position = {1, 2, 3}, .target = {4, 1, 1}, .near_m = 0.1f};
    const auto views = light_views(sun_at(40), 0, large, camera, {512, 0.05f, 4, 0.7f, 60, true});
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const float depth = float(random.uniform(0.1, 60)), slope = std::tan(0.5f * camera.fov_y_rad);
        const glm::vec3 forward = glm::normalize(camera.target - camera.position);
        const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
        const glm::vec3 p = camera.position + depth * (forward + slope * float(random.uniform(-1.78, 1.78)) * right +
                                                       slope * float(random.uniform(-1, 1)) * up);
        bool held = false;
        for (const LightView& view : views) {
            const glm::vec4 clip = view.view.view_projection * glm::vec4(p, 1);
            held |= std::max(std::fabs(clip.x), std::fabs(clip.y)) <= 1 - 2 * MAP_MARGIN + 1e-4f;
        }
        REQUIRE(held);
    }
    const Bounds small{glm::vec3(-1.0f), glm::vec3(1.0f)};
    CHECK(light_views(sun_at(40), 0, small, camera, {512, 0.05f, 4, 1.0f, 60, true}).back().view.view_projection ==
          light_views(sun_at(40), 0, small, {.position = {1, 2, 4}}, {512, 0.05f, 4, 1.0f, 60, true})
              .back()
              .view.view_projection);
}

TEST_CASE("a point light's shadow goes across a cube's twelve edges without a seam", "[05.cube_edges]") {
    // A ball on the path through each edge, and a shell of points behind it: rays decide which are in shadow.
    for (const char* method : {"hard", "pcf", "pcss", "vsm", "evsm", "msm"}) {
        std::vector<SceneObject> objects;
        std::vector<glm::vec3> balls;
        for (int axis = 0; axis < 3; ++axis)
            for (const float a : {-1.0f, 1.0f})
                for (const float b : {-1.0f, 1.0f}) {
                    glm::vec3 way(0.0f);
                    way[(axis + 1) % 3] = a;
                    way[(axis + 2) % 3] = b;
                    balls.push_back(glm::normalize(way));
                    objects.push_back(object_at(ball_file, balls.back(), glm::vec3(0.2f)));
                }
        ShadowScene test(objects, {{.kind = Light::Kind::point, .position = {0, 0, 0}, .size_m = 0.01f}});
        test.set({{"method", method},
                  {"resolution", "512"},
                  {"bias_m", "0.02"},
                  {"kernel", "3"},
                  {"blur", "1"},
                  {"mips", "off"}});
        std::vector<TestPoint> points;
        std::vector<bool> shadowed;
        Random random;
        for (const glm::vec3& ball : balls)
            for (int i = 0; i < 2000; ++i) {
                const glm::vec3 way = glm::normalize(ball + 0.25f * random.direction());
                const float away = std::asin(std::min(1.0f, glm::length(glm::cross(way, ball))));
                if (std::fabs(away - std::asin(0.2f)) < 0.03f) continue;  // its edge, where a filter is in between
                points.push_back({1.5f * way, -way});
                shadowed.push_back(away < std::asin(0.2f));
            }
        const std::vector<float> visible = test.visibility(points);
        size_t wrong = 0;
        for (size_t i = 0; i < points.size(); ++i) wrong += (visible[i] < 0.5f) != shadowed[i];
        INFO(method << ": " << wrong << " of " << points.size());
        CHECK(test.shadow.views == 6);
        CHECK(wrong == 0);
    }
}

TEST_CASE("a map is drawn again only where its light or a caster in its view has moved") {
    SceneObject mover = object_at(ball_file, {0, 0, 1}, glm::vec3(0.1f));
    mover.motion.path = {{.time_s = 0, .position = {0, 0, 1}, .scale = mover.scale},
                         {.time_s = 1, .position = {0.2f, 0, 1}, .scale = mover.scale}};
    const Light over{.kind = Light::Kind::spot, .position = {0, 0, 3}, .direction = {0, 0, -1}, .outer_rad = 0.4f};
    Light beside = over;
    beside.position.x = 30;
    ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {30, 0, 0}), mover}, {over, beside});
    const auto drawn = [&] {
        test.visibility({{0, 0, 0}, {0, 0, 1}});
        return test.shadow.drawn_views;
    };
    CHECK(drawn() == 2);
    CHECK(test.shadow.views == 2);
    CHECK(drawn() == 0);
    animate(test.scene, 0.5f);
    CHECK(drawn() == 1);  // the ball is in one light's view
    CHECK(drawn() == 0);
    test.scene.file.lights[1].position.z = 3.5f;
    CHECK(drawn() == 1);
    test.shadow.keep.set("off");
    CHECK(drawn() == 2);
    test.shadow.keep.set("on");
    test.set({{"resolution", "512"}});
    CHECK(drawn() == 2);
    test.set({{"method", "vsm"}});
    CHECK(drawn() == 2);
    test.set({{"blur", "5"}});
    CHECK(drawn() == 2);
    CHECK(drawn() == 0);
    test.shadow.prepare(test.gpu, test.scene);
    CHECK(drawn() == 2);
    test.scene.file.lights[0].shadow = false;
    drawn();
    CHECK(test.shadow.views == 1);
}

TEST_CASE("a lamp's map is drawn for one view, and read by another whose cascades are its own") {
    const Light sun{.kind = Light::Kind::directional, .direction = {0.3f, 0, -1}};
    const Light lamp{.kind = Light::Kind::spot, .position = {0, 0, 3}, .direction = {0, 0, -1}, .outer_rad = 0.6f};
    for (const char* method : {"pcf", "vsm"}) {
        INFO(method);
        std::vector<float> alone;
        for (const bool after_another : {false, true}) {
            ShadowScene test(
                {object_at(quad_file, {0, 0, 0}, glm::vec3(4.0f)), object_at(ball_file, {0, 0, 1}, glm::vec3(0.3f))},
                {lamp, sun});
            test.set({{"method", method}, {"distance_m", "8"}});
            if (after_another) {
                test.record_view(1, {9, 0, 0});
                test.visibility({{0, 0, 0}, {0, 0, 1}});  // the image has layers for both views
                test.shadow.prepare(test.gpu, test.scene);
                test.record_view(1, {9, 0, 0});
            }
            const std::vector<float> found = test.visibility(square(500, 0.9f));
            // The other view has drawn the lamp's map, and the cascade that holds the whole scene.
            CHECK(test.shadow.drawn_views == test.shadow.views - (after_another ? 2 : 0));
            if (!after_another)
                alone = found;
            else
                CHECK(found == alone);
        }
        const auto [least, most] = std::minmax_element(alone.begin(), alone.end());
        CHECK(*least < 0.1f);
        CHECK(*most > 0.9f);
    }
}

TEST_CASE("a caster is left out of a cascade only where all that its shadow may reach asks a finer one") {
    Random random;
    const Bounds scene{.lower = glm::vec3(-50), .upper = glm::vec3(50)};
    const Camera camera{.position = {0, 0, 5}, .target = {0, 0, 0}, .near_m = 0.1f, .far_m = 100};
    size_t left_out = 0, of = 0;
    for (int i = 0; i < 3000; ++i) {
        const Light sun{.kind = Light::Kind::directional, .direction = random.direction()};
        const std::vector<LightView> seen = light_views(sun, 0, scene, camera, {.resolution = 64, .split = 0.9f});
        REQUIRE(seen.size() == 3);
        Bounds box;
        const glm::vec3 middle = 12.0f * random.direction() * float(random.uniform(0, 1));
        box.add(middle);
        box.add(middle + 3.0f * random.direction() * float(random.uniform(0, 1)));
        for (size_t finer = 0; finer < 2; ++finer) {
            const LightView& coarse = seen[finer + 1];
            const bool holds = holds_shadow_of(seen[finer], box, coarse.data.texel);
            left_out += holds;
            ++of;
            if (!holds) continue;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
                const glm::vec4 at(glm::mix(box.lower, box.upper, pick), 1.0f);
                for (const glm::vec2 way : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
                    // A filter as wide as the margin, in the coarse map, then asked of the finer one.
                    glm::vec4 point = coarse.data.to_clip * at;
                    point += glm::vec4(0.99f * 2.0f * MAP_MARGIN * way, 0, 0);
                    point = seen[finer].data.to_clip * glm::inverse(coarse.data.to_clip) * point;
                    CHECK(std::max(std::fabs(point.x), std::fabs(point.y)) <= 1.0f - 2.0f * MAP_MARGIN);
                }
            }
        }
    }
    INFO(left_out << " of " << of);
    CHECK(left_out > of / 20);
    CHECK(left_out < of / 2);
}

TEST_CASE("a caster whose vertices move where it stands has its map drawn again") {
    ShadowScene test(
        {object_at(quad_file, {0, 0, -4}, glm::vec3(9.0f)), object_at("conformance/moving_skin.gltf", {0, 0, 2})},
        {{.kind = Light::Kind::spot, .position = {0, 0, 8}, .direction = {0, 0, -1}, .outer_rad = 0.7f}});
    const std::vector<TestPoint> points = square(2000, 4.0f);
    animate(test.scene, 0);
    const std::vector<float> before = test.visibility(points);
    animate(test.scene, 0.5f);
    CHECK(test.visibility(points) != before);
    CHECK(test.shadow.drawn_views == 1);
}

TEST_CASE("a spot that is too wide for one view has six, and the same shadow") {
    Light spot{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, -1}, .outer_rad = 1.0f};
    std::vector<float> narrow, wide;
    for (const float outer : {1.0f, 1.5f}) {
        spot.outer_rad = outer;
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 1}, glm::vec3(0.3f))}, {spot});
        test.set({{"bias_m", "0.02"}, {"method", "pcf"}});
        (outer < 1.1f ? narrow : wide) = test.visibility(square(2000, 0.9f));
        CHECK(test.shadow.views == (outer < 1.1f ? 1 : 1));  // the other five faces see nothing
    }
    size_t differ = 0;
    for (size_t i = 0; i < narrow.size(); ++i) differ += std::fabs(narrow[i] - wide[i]) > 0.5f;
    CHECK(differ < 20);
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
