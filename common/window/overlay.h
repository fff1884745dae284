// Dear ImGui over the picture: its context, its look, and the pass that draws it.
#pragma once
#include <imgui.h>

#include <string>

#include "common/window/swapchain.h"

namespace lightwalk {

namespace icon {
inline constexpr const char *folder = "\uf07c", *undo = "\uf0e2", *redo = "\uf01e", *list = "\uf03a", *help = "\uf059",
                            *move = "\uf047", *turn = "\uf021", *scale = "\uf065", *world = "\uf0ac",
                            *object = "\uf1b2", *group = "\uf247", *sun = "\uf185", *lamp = "\uf0eb", *spot = "\uf192",
                            *scatter = "\uf074", *eye = "\uf06e", *hidden = "\uf070", *lock = "\uf023",
                            *camera = "\uf03d", *effects = "\uf0d0", *image = "\uf03e", *cloud = "\uf0c2",
                            *water = "\uf043", *fog = "\uf0c9", *terrain = "\uf1fe", *scene = "\uf0e8";
}  // namespace icon

bool has_icons();  ///< once there is an Overlay

/// "icon text", or the text alone where the font is not installed.
inline std::string with_icon(const char* icon, const std::string& text) {
    return has_icons() ? std::string(icon) + " " + text : text;
}

/// The icon alone, or the text.
inline const char* icon_or(const char* icon, const char* text) { return has_icons() ? icon : text; }

class Overlay {
  public:
    Overlay(Gpu& gpu, Display& display, Swapchain& swapchain);
    ~Overlay();
    Overlay(const Overlay&) = delete;

    /// Between these two the caller builds its widgets.
    void begin();
    void end();

    /// Draws the widgets over the image acquired, which a transfer has just written, and leaves it ready to present.
    void draw(VkCommandBuffer commands);

    /// Whether input waits for a later frame: since 1.87 Dear ImGui may spread one frame's input over several, in
    /// order.
    bool input_is_left() const;

    ImFont* mono = nullptr;   ///< for code
    ImFont* large = nullptr;  ///< for headings

  private:
    void make_render_pass();
    void make_framebuffers();
    Gpu& gpu_;
    Swapchain& swapchain_;
    VkRenderPass render_pass_ = VK_NULL_HANDLE;
    VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
    std::vector<VkFramebuffer> framebuffers_;
    int generation_ = 0;
};

/// The field of a number that is typed into, not dragged, among all that are on the screen; 0: none.
ImGuiID number_typed_into();

/// Closes the list, menu or colour picker opened last; false: none is open but a question that waits for its answer.
bool close_popup();

/// Arrow keys go from widget to widget, Space presses the one that is marked. Not in windows that give these keys a
/// meaning of their own.
void enable_keyboard();

/// Whether a widget is marked by the keyboard. leave_keyboard() takes the mark away.
bool keyboard_marks();
void leave_keyboard();

/// The mouse drags no number any more, though it is still held.
void stop_dragging();

/// A child window without a border, with padding: Dear ImGui renamed its flags in 1.90.
inline void begin_padded_child(const char* id, ImVec2 size) {
#if IMGUI_VERSION_NUM >= 19000
    ImGui::BeginChild(id, size, ImGuiChildFlags_AlwaysUseWindowPadding);
#else
    ImGui::BeginChild(id, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
#endif
}

/// An invisible button on which items that follow may lie and be clicked; true if it was clicked itself.
inline bool button_under_others(const char* id, ImVec2 size) {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
    return ImGui::InvisibleButton(id, size);
#else
    const bool clicked = ImGui::InvisibleButton(id, size);
    ImGui::SetItemAllowOverlap();
    return clicked;
#endif
}

/// The course's colours: student version, reference, failure, success.
inline const ImVec4 mine_color{0.96f, 0.65f, 0.24f, 1.0f};
inline const ImVec4 reference_color{0.38f, 0.72f, 0.98f, 1.0f};
inline const ImVec4 error_color{1.0f, 0.45f, 0.40f, 1.0f};
inline const ImVec4 right_color{0.34f, 0.83f, 0.61f, 1.0f};
inline const ImVec4 quiet_color{0.60f, 0.64f, 0.70f, 1.0f};

}  // namespace lightwalk
