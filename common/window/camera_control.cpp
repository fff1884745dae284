#include "common/window/camera_control.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "common/window/activity.h"
#include "common/window/window_tool.h"

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

namespace {

constexpr float radians_per_pixel = 0.006f;

}  // namespace

void CameraMouse::move(const Input& input, glm::vec2 cursor_px, glm::uvec2 picture, double seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = input.left || input.right || input.middle;
    if (!held) dragging_ = false;
    if (tool_has_mouse(input, cursor_px, picture)) return;
    const bool over_picture = cursor_px.x < static_cast<float>(picture.x);
    const bool was_dragging = dragging_;
    if (held && over_picture && !io.WantCaptureMouse) dragging_ = true;
    if (!held && over_picture && !io.WantCaptureMouse) follow_mouse(cursor_px / glm::vec2(picture));
    // The way to where the button went down is no drag: a frame that takes long reads both at once.
    if (was_dragging && dragging_ && glm::length(input.moved) > 0.0f) drag(input);
    if (input.wheel != 0.0f && !io.WantCaptureMouse)
        CameraControl::zoom(chapter_.camera, input.wheel, chapter_.scene.bounds);
    if (dragging_ && input.right) fly(input, seconds);
    CameraControl::stay_above(chapter_.camera, chapter_.lowest_eye_m(chapter_.camera.position));
}

void CameraMouse::drag(const Input& input) {
    Camera& camera = chapter_.camera;
    const glm::vec2 turn = -radians_per_pixel * input.moved;
    if (input.middle || (input.left && input.shift))
        CameraControl::pan(camera, input.moved, static_cast<float>(display_.size().y));
    else if (input.left)
        CameraControl::orbit(camera, turn.x, -turn.y);
    else if (input.right)
        CameraControl::look(camera, turn.x, turn.y);
}

void CameraMouse::fly(const Input& input, double seconds) {
    const auto axis = [&](int plus, int minus) {
        return static_cast<float>(display_.is_held(plus)) - static_cast<float>(display_.is_held(minus));
    };
    const glm::vec3 direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S));
    if (direction == glm::vec3(0.0f)) return;
    const float speed = CameraControl::fly_speed(chapter_.scene.bounds) * (input.shift ? 5.0f : 1.0f);
    CameraControl::fly(chapter_.camera, direction * (speed * static_cast<float>(seconds)));
    activity_.stay(0.1);
}

// During a camera drag the tool sees no mouse, but is informed of it: a drag is not a click.
bool CameraMouse::tool_has_mouse(const Input& input, glm::vec2 cursor, glm::uvec2 picture) {
    auto* const tool = dynamic_cast<WindowTool*>(&chapter_);
    if (!tool) return false;
    const glm::vec2 size(picture);
    const bool over = cursor.x >= 0.0f && cursor.y >= 0.0f && cursor.x < size.x && cursor.y < size.y;
    const bool taken = tool->on_mouse(input, cursor, over && !dragging_ && !ImGui::GetIO().WantCaptureMouse);
    return taken && !dragging_;
}

// Where something in the picture follows the mouse, the chapter has knobs of these names: 0 to 1 from the upper left
// corner.
void CameraMouse::follow_mouse(glm::vec2 place) {
    for (KnobBase* knob : chapter_.all_knobs())
        if (auto* number = dynamic_cast<Knob<float>*>(knob);
            number && (knob->name == "mouse_x" || knob->name == "mouse_y")) {
            const float before = number->value;
            number->value = std::clamp(knob->name == "mouse_x" ? place.x : place.y, 0.0f, 1.0f);
            if (number->value != before) activity_.stay(0.1);
        }
}

}  // namespace lightwalk
