#include "common/window/display.h"

#define GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/gpu/device.h"
#include "common/window/event_log.h"

namespace lightwalk {

struct Display::Events {
    Input input;
    glm::vec2 last_cursor{0.0f};
    bool cursor_known = false;
};

namespace {

template <class F>
void note(GLFWwindow* window, const F& change) {
    auto* events = static_cast<Input*>(glfwGetWindowUserPointer(window));
    events->happened = events->acted = true;
    change(*events);
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    if (action == GLFW_PRESS) log_event("key");
    note(window, [&](Input& input) {
        if (action == GLFW_PRESS) input.pressed.push_back({key_by_letter(key, scancode), mods});
    });
}

void on_size(GLFWwindow* window, int width, int height) {
    log_event("size " + std::to_string(width) + " " + std::to_string(height));
    note(window, [](Input&) {});
}

void on_iconify(GLFWwindow* window, int minimised) {
    log_event(minimised ? "minimised" : "restored");
    note(window, [](Input&) {});
}

void on_scroll(GLFWwindow* window, double, double notches) {
    note(window, [&](Input& input) { input.wheel += static_cast<float>(notches); });
}

void note_mouse(GLFWwindow* window) { static_cast<Input*>(glfwGetWindowUserPointer(window))->happened = true; }

void on_cursor(GLFWwindow* window, double x, double y) {
    note_mouse(window);
    static_cast<Input*>(glfwGetWindowUserPointer(window))->cursor = {x, y};
}

void on_drop(GLFWwindow* window, int count, const char** files) {
    note(window, [&](Input& input) { input.dropped.insert(input.dropped.end(), files, files + count); });
}

// Xlib calls it when the X server is gone, and ends the program after it in any case.
int on_lost_display(void*) {
    std::fputs("error: the display went away\n", stderr);
    std::_Exit(1);
}

// It is GLFW that has loaded Xlib, where there is an X server.
void watch_x_server() {
    using Handler = int (*)(void*);
    void* const xlib = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!xlib) return;
    if (void* const set = dlsym(xlib, "XSetIOErrorHandler"))
        reinterpret_cast<Handler (*)(Handler)>(set)(on_lost_display);
    dlclose(xlib);
}

float limited_scale(float scale) { return std::clamp(scale, 1.0f, 4.0f); }

// Of Debian 12's two builds of GLFW 3.3 each knows one kind of display. Empty where this one knows the session's.
std::string other_library() {
    const std::string known = glfwGetVersionString();
    if (std::getenv("WAYLAND_DISPLAY") && known.find("Wayland") == std::string::npos)
        return "this GLFW knows X11 alone, and the session is Wayland's: as root, apt-get install libglfw3-wayland; ";
    if (std::getenv("DISPLAY") && known.find("X11") == std::string::npos)
        return "this GLFW knows Wayland alone: as root, apt-get install libglfw3; ";
    return {};
}

// From GLFW 3.4 on a program chooses between X11 and Wayland when it starts, and Wayland's library complains on the
// terminal where no session of it can be.
void choose_platform() {
#ifdef GLFW_PLATFORM
    const bool may_be_wayland = std::getenv("WAYLAND_DISPLAY") || std::getenv("XDG_RUNTIME_DIR");
    glfwInitHint(GLFW_PLATFORM, may_be_wayland ? GLFW_ANY_PLATFORM : GLFW_PLATFORM_X11);
#endif
}

}  // namespace

// By the scancode alone: the key may have been translated before.
int key_by_letter(int key, int scancode) {
    const bool is_digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;  // with Shift on French keyboards
    if (key <= GLFW_KEY_SPACE || key > GLFW_KEY_WORLD_2 || is_digit) return key;
    const char* const name = glfwGetKeyName(GLFW_KEY_UNKNOWN, scancode);
    const auto letter = static_cast<unsigned char>(name ? name[0] : 0);
    if (letter <= ' ' || letter > '~' || name[1]) return key;
    return letter >= 'a' && letter <= 'z' ? letter - 'a' + GLFW_KEY_A : letter;
}

Display::Display(const std::string& title, WindowSize size, const std::string& instead)
    : without("without a window: " + instead), title_(title) {
    choose_platform();
    if (!glfwInit()) {
        const char* why = nullptr;
        glfwGetError(&why);
        throw InputError("no display" + (why ? " (" + std::string(why) + ")" : std::string()) + "; " + other_library() +
                         without);
    }
    watch_x_server();
    if (!glfwVulkanSupported()) {
        glfwTerminate();
        list_devices();  // throws where there is no driver
        throw InputError("this display cannot show Vulkan's pictures; " + without);
    }
    glm::ivec2 wanted = size.pixels + size.scaled;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        float scale = 1.0f;
        glfwGetMonitorContentScale(monitor, &scale, nullptr);
        wanted = size.pixels + glm::ivec2(glm::vec2(size.scaled) * limited_scale(scale));
        glm::ivec2 corner(0), area(0);
        glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &area.x, &area.y);
        if (area.x > 0 && area.y > 0) wanted = glm::min(wanted, area);
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window = glfwCreateWindow(wanted.x, wanted.y, title.c_str(), nullptr, nullptr);
    if (!window) {
        const char* why = nullptr;
        glfwGetError(&why);
        const std::string reason = why ? why : "unknown reason";
        glfwTerminate();
        throw InputError("no window: " + reason + "; " + without);
    }
    glfwSetWindowSizeLimits(window, 200, 150, GLFW_DONT_CARE, GLFW_DONT_CARE);
    events_ = std::make_unique<Events>();
    glfwSetWindowUserPointer(window, &events_->input);
    glfwSetKeyCallback(window, on_key);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetDropCallback(window, on_drop);
    // A press that ends before the next poll() is still reported by it.
    glfwSetInputMode(window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { note(w, [](Input&) {}); });
    // A mouse that comes back to the pixel where it left has not moved.
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { note_mouse(w); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { note(w, [](Input&) {}); });
    glfwSetFramebufferSizeCallback(window, on_size);
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { note(w, [](Input&) {}); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { note(w, [](Input&) {}); });
    glfwSetWindowIconifyCallback(window, on_iconify);
}

Display::~Display() {
    glfwDestroyWindow(window);
    glfwTerminate();
}

std::vector<const char*> Display::surface_extensions() {
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    return {names, names + count};
}

VkSurfaceKHR Display::make_surface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "the window's surface");
    return surface;
}

bool Display::takes(VkInstance instance, VkPhysicalDevice physical, uint32_t queue_family) const {
    const VkSurfaceKHR surface = make_surface(instance);
    VkBool32 supported = VK_FALSE;
    if (vkGetPhysicalDeviceSurfaceSupportKHR(physical, queue_family, surface, &supported) != VK_SUCCESS)
        supported = VK_FALSE;
    vkDestroySurfaceKHR(instance, surface, nullptr);
    return supported == VK_TRUE;
}

Input Display::poll(double wait_s) {
    if (wait_s > 0.0)
        unlocked([&] { glfwWaitEventsTimeout(wait_s); });
    else
        glfwPollEvents();
    Input& now = events_->input;
    now.left = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    now.right = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    now.middle = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS;
    now.shift = is_held(GLFW_KEY_LEFT_SHIFT) || is_held(GLFW_KEY_RIGHT_SHIFT);
    now.moved = events_->cursor_known ? now.cursor - events_->last_cursor : glm::vec2(0.0f);
    events_->last_cursor = now.cursor;
    events_->cursor_known = events_->cursor_known || now.cursor != glm::vec2(0.0f);
    now.acted = now.acted || (now.happened && (now.left || now.right || now.middle));
    Input result = now;
    now.pressed.clear();
    now.wheel = 0.0f;
    now.happened = now.acted = false;
    return result;
}

std::vector<std::filesystem::path> Display::take_dropped() { return std::exchange(events_->input.dropped, {}); }

void Display::stay_open() { glfwSetWindowShouldClose(window, GLFW_FALSE); }
void Display::say(const std::string& words) {
    const std::string& behind = words.empty() ? document_ : words;
    glfwSetWindowTitle(window, (behind.empty() ? title_ : title_ + " · " + behind).c_str());
}

void Display::name_document(const std::string& name) {
    if (std::exchange(document_, name) != name) say("");
}

bool Display::wants_to_close() const { return glfwWindowShouldClose(window); }
bool Display::is_minimised() const { return glfwGetWindowAttrib(window, GLFW_ICONIFIED); }
bool Display::is_held(int key) const { return glfwGetKey(window, key) == GLFW_PRESS; }

glm::uvec2 Display::framebuffer_size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    return {width, height};
}

glm::ivec2 Display::size() const {
    glm::ivec2 result(0);
    glfwGetWindowSize(window, &result.x, &result.y);
    return result;
}

float Display::scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window, &x, &y);
    return limited_scale(x);
}

}  // namespace lightwalk
