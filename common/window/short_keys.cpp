
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <deque>
#include <set>

#include "common/window/display.h"

namespace lightwalk {

#if IMGUI_VERSION_NUM >= 18700
// Releases queued input up to a modifier's change, together with the keys before it.
namespace {

ImVector<ImGuiInputEvent> later;  // events after a modifier's change that must wait

bool changes_modifier(const ImGuiInputEvent& event) {
    if (event.Type != ImGuiInputEventType_Key) return false;
    const int key = event.Key.Key;
    return key == ImGuiMod_Ctrl || key == ImGuiMod_Alt || key == ImGuiMod_Super ||
           (key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper && key != ImGuiKey_LeftShift &&
            key != ImGuiKey_RightShift);
}

}  // namespace

void hold_short_keys(GLFWwindow*) {}

void pass_short_keys() {
    ImVector<ImGuiInputEvent>& queue = ImGui::GetCurrentContext()->InputEventsQueue;
    bool pressed = false;
    for (int i = 0; i < queue.Size; ++i) {
        if (pressed && changes_modifier(queue[i])) {
            for (int k = i; k < queue.Size; ++k) later.push_back(queue[k]);
            queue.resize(i);
            return;
        }
        pressed =
            pressed || (queue[i].Type == ImGuiInputEventType_Key && queue[i].Key.Down && !changes_modifier(queue[i]));
    }
}

void note_keys_were_read() {
    ImVector<ImGuiInputEvent>& queue = ImGui::GetCurrentContext()->InputEventsQueue;
    for (const ImGuiInputEvent& event : later) queue.push_back(event);
    later.clear();
}

bool short_keys_wait() { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }
#else
namespace {

struct KeyEvent {
    int key, scancode, action, mods;
    unsigned character = 0;  ///< typed character, instead of a key
};

GLFWwindow* keyboard_of = nullptr;
GLFWkeyfun imgui_key = nullptr;
GLFWcharfun imgui_character = nullptr;
std::set<int> changed_keys;  // since a frame has read them
bool was_typed = false;      // text, since then
std::deque<KeyEvent> waiting;

bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }
bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

// Of a modifier a frame knows one state, and takes all keys and text that are new in it for pressed with that one.
bool may_pass(const KeyEvent& event) {
    if (event.character || event.action == GLFW_REPEAT) return true;
    if (is_modifier(event.key) && (was_typed || !std::all_of(changed_keys.begin(), changed_keys.end(), is_modifier)))
        return false;
    return changed_keys.insert(event.key).second;
}

// Letters and Shift for the text that they make, which comes as characters: nobody asks for their state, but for that of
// Space, which presses what the arrow keys mark.
bool makes_text(const KeyEvent& event) {
    if (event.character || event.key == GLFW_KEY_SPACE) return false;
    if (is_shift(event.key)) return waiting.empty() && changed_keys.empty();
    if (event.key >= GLFW_KEY_ESCAPE || (event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER))) return false;
    return !changed_keys.contains(event.key) &&
           std::none_of(waiting.begin(), waiting.end(), [&](const KeyEvent& one) { return one.key == event.key; });
}

void pass(const KeyEvent& event) {
    was_typed |= event.character != 0;
    if (event.character)
        imgui_character(keyboard_of, event.character);
    else
        imgui_key(keyboard_of, event.key, event.scancode, event.action, event.mods);
}

void take(const KeyEvent& event) {
    if (makes_text(event) || (waiting.empty() && may_pass(event)))
        pass(event);
    else
        waiting.push_back(event);
}

}  // namespace

void hold_short_keys(GLFWwindow* window) {
    keyboard_of = window;
    changed_keys.clear();
    waiting.clear();
    was_typed = false;
    imgui_key = glfwSetKeyCallback(window, [](GLFWwindow*, int key, int scancode, int action, int mods) {
        take({key_by_letter(key, scancode), scancode, action, mods});
    });
    imgui_character = glfwSetCharCallback(window, [](GLFWwindow*, unsigned character) {
        take({0, 0, 0, 0, character});
    });
}

void pass_short_keys() {
    while (!waiting.empty() && may_pass(waiting.front())) {
        pass(waiting.front());
        waiting.pop_front();
    }
}

void note_keys_were_read() {
    changed_keys.clear();
    was_typed = false;
}
bool short_keys_wait() { return !waiting.empty(); }
#endif

}  // namespace lightwalk
