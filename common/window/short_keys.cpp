#include "common/window/short_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <deque>
#include <set>

namespace lightwalk {

#if IMGUI_VERSION_NUM >= 18700
void hold_short_keys(GLFWwindow*) {}
void pass_short_keys() {}
void note_keys_were_read() {}
bool short_keys_wait() { return false; }
#else
namespace {

struct KeyEvent {
    int key, scancode, action, mods;
};

GLFWwindow* keyboard_of = nullptr;
GLFWkeyfun imgui_key = nullptr;
std::set<int> changed_keys;  // since a frame has read them
std::deque<KeyEvent> waiting;

bool may_pass(const KeyEvent& event) { return event.action == GLFW_REPEAT || changed_keys.insert(event.key).second; }

// Letters and Shift for the text that they make, which comes as characters: nobody asks for their state.
bool makes_text(const KeyEvent& event) {
    if (event.key == GLFW_KEY_LEFT_SHIFT || event.key == GLFW_KEY_RIGHT_SHIFT)
        return waiting.empty() && changed_keys.empty();
    if (event.key >= GLFW_KEY_ESCAPE || (event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER))) return false;
    return !changed_keys.contains(event.key) &&
           std::none_of(waiting.begin(), waiting.end(), [&](const KeyEvent& one) { return one.key == event.key; });
}

}  // namespace

void hold_short_keys(GLFWwindow* window) {
    keyboard_of = window;
    changed_keys.clear(), waiting.clear();
    imgui_key = glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int scancode, int action, int mods) {
        const KeyEvent event{key, scancode, action, mods};
        if (makes_text(event) || (waiting.empty() && may_pass(event)))
            imgui_key(from, key, scancode, action, mods);
        else
            waiting.push_back(event);
    });
}

void pass_short_keys() {
    while (!waiting.empty() && may_pass(waiting.front())) {
        const KeyEvent event = waiting.front();
        waiting.pop_front();
        imgui_key(keyboard_of, event.key, event.scancode, event.action, event.mods);
    }
}

void note_keys_were_read() { changed_keys.clear(); }
bool short_keys_wait() { return !waiting.empty(); }
#endif

}  // namespace lightwalk
