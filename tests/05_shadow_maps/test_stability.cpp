// Where maps of depth fail: a bound where they hold, the size of the failure where they do not.
#include "shadow_fixture.h"

using namespace lightwalk;

namespace {

const std::vector<SceneObject> plane_alone{object_at(quad_file, {0, 0, 0})};

// A plane that falls, as the light sees it, along the diagonal of texels: where most bias is needed.
struct Tilted {
    Light light{.kind = Light::Kind::directional, .direction = glm::normalize(glm::vec3(-0.5f, -0.5f, -0.7f))};
    SceneObject plane = object_at(quad_file, {0, 0, 0});
    std::vector<TestPoint> points = square(20000, 0.9f);
    explicit Tilted(double degrees) {
        const glm::vec3 right = glm::normalize(glm::cross(light.direction, {0, 1, 0}));
        const glm::vec3 up = glm::cross(right, light.direction);
        const float angle = static_cast<float>(glm::radians(degrees));
        const glm::vec3 n = -std::cos(angle) * light.direction + std::sin(angle) * std::sqrt(0.5f) * (right + up);
        plane.rotation_deg = glm::degrees(glm::vec3(-std::asin(n.y), std::atan2(n.x, n.z), 0.0f));
        const glm::mat4 turn = local_transform(plane);
        for (TestPoint& p : points) {
            p.position = turn * glm::vec4(p.position, 1);
            p.facing = n;
        }
    }
};

// The least value of a knob with which none of the points is dark, between 0 and `most`.
double least_without_acne(ShadowScene& test, const std::vector<TestPoint>& points, Knob<float>& knob, double most) {
    double low = 0, high = most;
    for (int step = 0; step < 9; ++step) {
        knob.value = static_cast<float>(0.5 * (low + high));
        (test.dark(points) > 0 ? low : high) = static_cast<double>(knob.value);
    }
    return high;
}

// Of the one view there is, in metres.
double texel_of(const ShadowScene& test, const Light& light) {
    const LightViewOptions options{test.shadow.resolution, 0.05f, 1, 0.5f, 1000.0f, true};
    return double(light_views(light, 10, test.scene.bounds, test.camera, options).front().data.texel);
}

}  // namespace

TEST_CASE("acne: the constant bias that a plane needs is half a texel's diagonal times the tangent",
          "[05.constant_bias]") {
    // 0.71, 1.22, 2.64, 8.1 and 40.5 texels.
    for (const double degrees : {45.0, 60.0, 75.0, 85.0, 89.0}) {
        const Tilted tilted(degrees);
        ShadowScene test({tilted.plane}, {tilted.light});
        test.set({{"cascades", "1"}, {"distance_m", "1000"}, {"resolution", "1024"}});
        const double texel = texel_of(test, tilted.light), tangent = std::tan(glm::radians(degrees));
        CHECK(test.dark(tilted.points) > 0.3);  // without any, nearly half of it is in its own shadow
        const double needed =
            least_without_acne(test, tilted.points, test.shadow.bias_m, std::min(1.0, 1.2 * tangent * texel)) / texel;
        INFO(degrees << " degrees: " << needed << " texels");
        CHECK(needed <= 1.02 * std::sqrt(0.5) * tangent);
        CHECK(needed >= 0.85 * std::sqrt(0.5) * tangent);
    }
}

TEST_CASE("acne: slope bias, normal offset and receiver plane are enough at every angle, and half of it is not") {
    for (const double degrees : {45.0, 60.0, 75.0, 85.0, 88.5}) {
        INFO(degrees << " degrees");
        const Tilted tilted(degrees);
        ShadowScene test({tilted.plane}, {tilted.light});
        test.set({{"cascades", "1"}, {"distance_m", "1000"}, {"resolution", "256"}});
        const auto& points = tilted.points;
        // The rasteriser moves vertices to 256ths of a texel, and depth goes with them.
        test.shadow.bias_m.value = float(texel_of(test, tilted.light) * std::tan(glm::radians(degrees)) / 100);
        for (const char* knob : {"slope", "normal_offset"}) {
            test.set({{knob, "1.02"}});
            CHECK(test.dark(points) == 0);
            test.set({{knob, "0.5"}});
            CHECK(test.dark(points) > 0.005);
            test.set({{knob, "0"}});
        }
        test.set({{"receiver_plane", "on"}});
        CHECK(test.dark(points) == 0);
        for (const char* kernel : {"3", "5", "9"}) {
            test.set({{"method", "pcf"}, {"kernel", kernel}});
            for (const float visible : test.visibility(points)) REQUIRE(visible > 0.9999f);
            test.set({{"receiver_plane", "off"}, {"slope", "1.02"}});
            for (const float visible : test.visibility(points)) REQUIRE(visible > 0.9999f);
            test.set({{"receiver_plane", "on"}, {"slope", "0"}});
        }
    }
}

TEST_CASE("acne: at 89.5 degrees the slope's limit is reached, and the bias falls short", "[05.slope_limit]") {
    const Tilted tilted(89.5);
    ShadowScene test({tilted.plane}, {tilted.light});
    test.set({{"cascades", "1"}, {"distance_m", "1000"}, {"resolution", "256"}, {"slope", "1.02"}});
    const double dark = test.dark(tilted.points);
    INFO(dark);
    CHECK(dark > 0.02);
    CHECK(dark < 0.4);
}

TEST_CASE("peter-panning: a bias lifts the shadow off its caster by as much", "[05.peter_panning]") {
    // A sheet 2 cm above the plane.
    for (const double bias : {0.01, 0.03}) {
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 0.02f}, {0.5f, 0.5f, 1})},
                         {sun_at(0)});
        test.set({{"cascades", "1"}});
        test.shadow.bias_m.value = static_cast<float>(bias);
        CHECK(test.dark(square(1000, 0.4f)) == (bias < 0.02 ? 1.0 : 0.0));
    }
}

TEST_CASE("a point behind a spot light, beside it or at it is lit, and no NaN") {
    const Light spot{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, -1}, .outer_rad = 0.5f};
    for (const char* method : {"hard", "pcf", "pcss", "vsm", "evsm", "msm"}) {
        INFO(method);
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 1}, glm::vec3(0.2f))}, {spot});
        test.set({{"method", method}, {"bias_m", "0.01"}});
        CHECK(test.visibility({{0, 0, 0}, {0, 0, 1}}) < 0.1f);  // so there is a shadow
        for (const glm::vec3 p : {glm::vec3(0, 0, 4), glm::vec3(0, 0, 3), glm::vec3(0.1f, 0, 2.5f)})
            CHECK(test.visibility({p, {0, 0, -1}}) == 1.0f);
        for (const glm::vec3 p : {glm::vec3(0, 0, 2), glm::vec3(1, 0, 2), glm::vec3(1, 0, 1.9f)}) {
            const float visible = test.visibility({p, glm::normalize(glm::vec3(-1, 0, 1e-3f))});
            CHECK((visible == 1.0f || visible == 0.0f));
        }
    }
}

TEST_CASE("outside of its map a light is not in shadow") {
    const Light spot{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, -1}, .outer_rad = 0.2f};
    for (const char* method : {"hard", "pcf", "pcss", "vsm", "evsm", "msm"}) {
        INFO(method);
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 1})}, {spot, sun_at(0)});
        test.set({{"method", method}, {"distance_m", "1"}, {"cascades", "1"}, {"bias_m", "0.01"}});
        CHECK(test.visibility({{0, 0, 0}, {0, 0, 1}}) < 0.1f);
        CHECK(test.visibility({{0.9f, 0, 0}, {0, 0, 1}}) == 1.0f);       // a blocker above it, but the cone ends before
        CHECK(test.visibility({{0.9f, 0.9f, -40}, {0, 0, 1}}) == 1.0f);  // beyond the far plane
        CHECK(test.visibility({{30, 0, 0}, {0, 0, 1}, 1}) == 1.0f);
    }
}

TEST_CASE("a caster nearer than the near plane, or around it, casts all the same") {
    for (const float z : {1.99f, 1.97f, 1.95f, 1.5f}) {
        INFO("at " << z);
        const Light spot{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, -1}, .outer_rad = 0.5f};
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, z}, glm::vec3(0.5f))}, {spot});
        test.set({{"bias_m", "0.01"}, {"near_m", "0.1"}});
        CHECK(test.dark(square(1000, 0.3f)) == 1);
    }
    ShadowScene behind(
        {object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 2.01f})},
        {{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, -1}, .outer_rad = 0.5f}});
    behind.set({{"bias_m", "0.01"}});
    CHECK(behind.dark(square(1000, 0.3f)) == 0);
}

TEST_CASE("no caster: no map, and all is lit") {
    ShadowScene empty({}, {sun_at(10)});
    CHECK(empty.visibility({{0, 0, 0}, {0, 0, 1}}) == 1.0f);
    CHECK(empty.shadow.views == 0);
    const Light away{.kind = Light::Kind::spot, .position = {0, 0, 2}, .direction = {0, 0, 1}, .outer_rad = 0.5f};
    ShadowScene beside(plane_alone, {away});
    CHECK(beside.visibility({{0, 0, 3}, {0, 0, -1}}) == 1.0f);
    CHECK(beside.shadow.views == 0);
}

TEST_CASE("a caster of one texel is always found, one of half a texel every other time", "[05.thin_caster]") {
    const auto found = [](float texels) {
        int seen = 0;
        for (int i = 0; i < 40; ++i) {
            const Light light = sun_at(0);
            const float x = -0.5f + 0.0237f * static_cast<float>(i);
            ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {x, 0, 0.5f}, {0.01f, 1, 1})},
                             {light});
            test.set({{"cascades", "1"}, {"distance_m", "1000"}, {"resolution", "128"}, {"bias_m", "0.01"}});
            const float width = texels * static_cast<float>(texel_of(test, light));
            test.scene.file.objects[1].scale.x = 0.5f * width;
            test.scene.load(test.gpu, SceneFile(test.scene.file), test_model);
            std::vector<TestPoint> across;
            for (int k = -60; k <= 60; ++k)
                across.push_back({{x + 0.02f * width * static_cast<float>(k), 0, 0}, {0, 0, 1}});
            seen += test.dark(across) > 0;
        }
        return seen;
    };
    CHECK(found(1.01f) == 40);
    CHECK(found(0.5f) > 10);
    CHECK(found(0.5f) < 30);
}

TEST_CASE("lamps of no size and of a huge one: soft shadows stay numbers from 0 to 1") {
    for (const float size : {0.0f, 1e-6f, 0.1f, 10.0f, 1000.0f}) {
        const Light spot{.kind = Light::Kind::spot,
                         .position = {0, 0, 2},
                         .direction = {0, 0, -1},
                         .outer_rad = 0.8f,
                         .size_m = size};
        Light sun = sun_at(20);
        sun.size_rad = std::min(size, 1.5f);
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 0.5f}, glm::vec3(0.3f))},
                         {spot, sun});
        test.set({{"method", "pcss"}, {"receiver_plane", "on"}, {"bias_m", "0.001"}});
        int between = 0;
        for (uint32_t light = 0; light < 2; ++light) {
            std::vector<TestPoint> points = square(2000, 0.9f);
            for (TestPoint& p : points) p.light = light;
            for (const float visible : test.visibility(points)) {
                REQUIRE(visible >= 0.0f);
                REQUIRE(visible <= 1.0f);
                between += light == 0 && visible > 0.02f && visible < 0.98f;
            }
        }
        INFO(size << " m: " << between << " of 2,000 in half shadow");
        if (size < 1e-3f) CHECK(between < 60);  // a texel's width of it
        if (size == 0.1f) CHECK(between > 60);
    }
}
