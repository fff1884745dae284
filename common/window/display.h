// The window system: one window, and the user's input since the last poll.
#pragma once
#include <vulkan/vulkan.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace lightwalk {

struct KeyPress {
    int key = 0;   ///< GLFW_KEY_..., by letter
    int mods = 0;  ///< GLFW_MOD_...
};

/// The key as its layout names it: Ctrl+Z is where a German keyboard has Z. Keys of other alphabets keep their positions.
int key_by_letter(int key, int scancode);

/// Lengths in the window's own coordinates, y down.
struct Input {
    glm::vec2 cursor{0.0f}, moved{0.0f};
    std::vector<std::filesystem::path> dropped{};
    float wheel = 0.0f;                                               ///< notches, away from the person is positive
    bool left = false, right = false, middle = false, shift = false;  ///< held now
    std::vector<KeyPress> pressed;
    bool happened = false;  ///< anything at all: worth a new panel
    bool acted = false;     ///< more than that the mouse came along: worth a new picture
};

/// Of a window, in pixels: a part that grows with the desktop's scale, and one that does not.
struct WindowSize {
    glm::ivec2 scaled{0}, pixels{0};
};

class Display {
  public:
    /// Throws InputError if there is no display; `instead` is a command that needs none.
    Display(const std::string& title, WindowSize size, const std::string& instead);
    ~Display();
    Display(const Display&) = delete;

    GLFWwindow* window = nullptr;
    const std::string without;  ///< words for an error: what to type instead

    static std::vector<const char*> surface_extensions();
    VkSurfaceKHR make_surface(VkInstance instance) const;
    /// Whether a device's queues can draw into this window.
    bool takes(VkInstance instance, VkPhysicalDevice physical, uint32_t queue_family) const;

    /// Input since the last call; waits up to `wait_s` for some.
    Input poll(double wait_s);

    /// Files that were dropped on the window since the last call.
    std::vector<std::filesystem::path> take_dropped();

    bool wants_to_close() const;
    void stay_open();  ///< takes the wish to close back
    bool is_minimised() const;
    bool is_held(int key) const;
    glm::uvec2 framebuffer_size() const;  ///< pixels; 0 while minimised on some systems
    glm::ivec2 size() const;              ///< in the window's own coordinates
    float pixels_per_unit() const { return float(framebuffer_size().x) / float(size().x); }
    float scale() const;                 ///< of text, as the desktop asks for
    void say(const std::string& words);  ///< behind the window's title; empty: the document's name
    void name_document(const std::string& name);

  private:
    struct Events;
    const std::string title_;
    std::string document_;
    std::unique_ptr<Events> events_;
};

/// Dear ImGui before 1.87 reads key states once per frame and loses a key pressed and released within one: Return
/// held for 10 ms in a window that takes 100 ms per frame. From here on each key changes at most once per frame, and
/// later events wait, in order; text too. A modifier released in the frame in which its key was pressed is held until
/// a frame has seen both: Ctrl+A is not A. Later versions of Dear ImGui do the former themselves, not the latter.
/// Call it after Dear ImGui has installed its callbacks.
void hold_short_keys(GLFWwindow* window);

/// Releases the next queued input before a frame reads the keys.
void pass_short_keys();

/// A frame has read the keys. Before any others are noted.
void note_keys_were_read();

/// Whether a key waits for a later frame.
bool short_keys_wait();

}  // namespace lightwalk
