// The camera under mouse and keys: invariants of its motion.
#include <cmath>

#include "catch.h"
#include "common/window/camera_control.h"

using namespace lightwalk;

namespace {

Bounds unit_box() {
    Bounds box;
    box.add(glm::vec3(-1.0f));
    box.add(glm::vec3(1.0f));
    return box;
}

/// Where a point appears: x and y in units of half the picture's height, y up.
glm::vec2 project(const Camera& camera, glm::vec3 point) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 arm = point - camera.position;
    const float depth = glm::dot(arm, forward) * std::tan(0.5f * camera.fov_y_rad);
    return glm::vec2(glm::dot(arm, right), glm::dot(arm, glm::cross(right, forward))) / depth;
}

}  // namespace

TEST_CASE("orbit keeps the distance and the target, and stops before the poles") {
    Camera camera{.position = {1.0f, 2.0f, 3.0f}, .target = {0.5f, 0.0f, 0.0f}};
    const float distance = glm::distance(camera.position, camera.target);
    for (int i = 0; i < 100; ++i) {
        CameraControl::orbit(camera, 0.3f, 0.2f);
        REQUIRE(std::abs(glm::distance(camera.position, camera.target) - distance) < 1e-4f * distance);
        REQUIRE(std::abs(glm::normalize(camera.target - camera.position).y) < 0.9999f);
    }
    CHECK(camera.target == glm::vec3(0.5f, 0.0f, 0.0f));
}

TEST_CASE("pan moves the target's plane with the pointer") {
    Camera camera{.position = {0.0f, 1.0f, 4.0f}, .target = {0.0f, 0.5f, 0.0f}};
    const glm::vec3 grabbed = camera.target;
    const float height = 500.0f;
    CameraControl::pan(camera, {120.0f, -70.0f}, height);
    const glm::vec2 there = project(camera, grabbed) * 0.5f * height;  // pixels, y up
    CHECK(std::abs(there.x - 120.0f) < 0.1f);
    CHECK(std::abs(there.y - 70.0f) < 0.1f);
}

TEST_CASE("zoom never reaches the target nor loses it, and nothing near is cut off") {
    Camera camera;
    for (int i = 0; i < 500; ++i) CameraControl::zoom(camera, 1.0f, unit_box());
    const float nearest = glm::distance(camera.position, camera.target);
    CHECK(nearest > 0.0f);
    CHECK(camera.near_m < nearest);
    for (int i = 0; i < 500; ++i) CameraControl::zoom(camera, -1.0f, unit_box());
    CHECK(glm::distance(camera.position, camera.target) < 100.0f);
}

TEST_CASE("look turns the view and leaves the eye where it is") {
    Camera camera;
    const glm::vec3 eye = camera.position;
    CameraControl::look(camera, 0.4f, 0.1f);
    CHECK(camera.position == eye);
    CHECK(glm::distance(camera.target, glm::vec3(0.0f)) > 0.5f);
}

TEST_CASE("frame shows the whole scene in pictures of any shape") {
    for (const float aspect : {0.4f, 1.0f, 2.5f}) {
        Camera camera{.position = {0.2f, 0.1f, 0.3f}};
        CameraControl::frame(camera, unit_box(), aspect);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
            const glm::vec2 at = project(camera, pick * 2.0f - 1.0f);
            CHECK(std::abs(at.x) < aspect);
            CHECK(std::abs(at.y) < 1.0f);
        }
    }
}

TEST_CASE("an eye below the ground is lifted, its target stays") {
    Camera camera{.position = {1, -3, 2}, .target = {4, 5, 6}};
    CameraControl::stay_above(camera, std::nullopt);
    CHECK(camera.position == glm::vec3(1, -3, 2));
    CameraControl::stay_above(camera, 1.5f);
    CHECK(camera.position == glm::vec3(1, 1.5f, 2));
    CHECK(camera.target == glm::vec3(4, 5, 6));
    CameraControl::stay_above(camera, 0.5f);
    CHECK(camera.position.y == 1.5f);
}
