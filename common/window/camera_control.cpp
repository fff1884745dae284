#include "common/window/camera_control.h"

#include <algorithm>
#include <cmath>

namespace lightwalk {
namespace {

float radius_of(const Bounds& bounds) {
    return bounds.empty() ? 1.0f : std::max(0.5f * glm::length(bounds.extent()), 1e-4f);
}

struct Axes {
    glm::vec3 right, up, forward;
};

Axes axes(const Camera& camera) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {right, glm::cross(right, forward), forward};
}

// The direction turned about +y and tilted, at most to a degree from the poles, where "up" would be undefined.
glm::vec3 turned(glm::vec3 direction, float turn_rad, float tilt_rad) {
    constexpr float limit = 1.553f;
    const float tilt = std::clamp(std::asin(std::clamp(direction.y, -1.0f, 1.0f)) + tilt_rad, -limit, limit);
    const float turn = std::atan2(direction.x, direction.z) + turn_rad;
    return {std::cos(tilt) * std::sin(turn), std::sin(tilt), std::cos(tilt) * std::cos(turn)};
}

// Near objects must not be clipped. With reversed depth a close near plane costs no precision.
void keep_near(Camera& camera) {
    camera.near_m = std::min(camera.near_m, 0.05f * glm::distance(camera.position, camera.target));
}

}  // namespace

void CameraControl::orbit(Camera& camera, float turn_rad, float tilt_rad) {
    camera.up = {0.0f, 1.0f, 0.0f};
    const glm::vec3 arm = camera.position - camera.target;
    camera.position = camera.target + glm::length(arm) * turned(glm::normalize(arm), turn_rad, tilt_rad);
}

void CameraControl::pan(Camera& camera, glm::vec2 pixels, float height) {
    const float distance = glm::distance(camera.position, camera.target);
    const float metres_per_pixel = 2.0f * distance * std::tan(0.5f * camera.fov_y_rad) / std::max(height, 1.0f);
    fly(camera, {-pixels.x * metres_per_pixel, pixels.y * metres_per_pixel, 0.0f});
}

void CameraControl::zoom(Camera& camera, float notches, const Bounds& bounds) {
    const glm::vec3 arm = camera.position - camera.target;
    const float radius = radius_of(bounds);
    const float distance = glm::length(arm);
    const float wanted = std::clamp(distance * std::pow(0.9f, notches), 0.002f * radius, 40.0f * radius);
    camera.position = camera.target + arm * (wanted / distance);
    keep_near(camera);
}

void CameraControl::look(Camera& camera, float turn_rad, float tilt_rad) {
    camera.up = {0.0f, 1.0f, 0.0f};
    const glm::vec3 arm = camera.target - camera.position;
    camera.target = camera.position + glm::length(arm) * turned(glm::normalize(arm), turn_rad, tilt_rad);
}

void CameraControl::fly(Camera& camera, glm::vec3 metres) {
    const Axes a = axes(camera);
    const glm::vec3 step = metres.x * a.right + metres.y * a.up + metres.z * a.forward;
    camera.position += step;
    camera.target += step;
}

void CameraControl::frame(Camera& camera, const Bounds& bounds, float aspect) {
    if (bounds.empty()) return;
    const glm::vec3 back = -axes(camera).forward;
    const float half_height = 0.5f * camera.fov_y_rad;
    const float half_width = std::atan(std::tan(half_height) * aspect);
    const float distance = radius_of(bounds) / std::sin(std::min(half_height, half_width));
    camera.target = bounds.center();
    camera.position = camera.target + back * distance;
    camera.far_m = std::max(camera.far_m, 4.0f * distance);
    keep_near(camera);
}

float CameraControl::fly_speed(const Bounds& bounds) { return 0.4f * radius_of(bounds); }

void CameraControl::stay_above(Camera& camera, const std::optional<float>& lowest_m) {
    if (lowest_m && camera.position.y < *lowest_m) camera.position.y = *lowest_m;
}

}  // namespace lightwalk
