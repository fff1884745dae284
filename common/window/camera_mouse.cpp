#include "common/window/camera_mouse.h"

#include <GLFW/glfw3.h>

#include <algorithm>

#include "common/window/camera_control.h"

namespace lightwalk {
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
