// A chapter's additions to its window: panels, mouse tools, keys, its own saving.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/window/blit.h"
#include "common/window/display.h"
#include "common/window/knob_widgets.h"

namespace lightwalk {

/// The chapter's clock in the window.
struct WindowClock {
    float time_s = 0;
    bool runs = false;
};

/// A chapter that is one too is asked by the window. True: taken, and nothing else happens with it.
class WindowTool {
  public:
    virtual ~WindowTool() = default;
    AutoChoices* automatic = nullptr;  ///< the window's, for knobs in panels of the chapter's own; null: no window

    /// The mouse over the picture or held since it was there; `cursor_px` in pixels of the picture.
    virtual bool on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) = 0;
    virtual bool on_key(const KeyPress& key) = 0;
    virtual void on_drop(const std::vector<std::filesystem::path>& files) = 0;

    /// Dear ImGui's widgets beside the picture, in a dock `dock_px` wide on the left; 0: there is no room. True: the picture
    /// has to be drawn again.
    virtual bool draw_panels(const Area& picture, float dock_px, float scale) = 0;
    virtual int dock_width() const { return 0; }                         ///< in pixels at scale 1
    virtual std::vector<std::string> mouse_words() const { return {}; }  ///< what it does; none: it moves the camera

    virtual std::string document() const { return {}; }  ///< for the window's title: what Ctrl+S writes
    virtual bool on_save() = 0;                          ///< Ctrl+S
    virtual bool may_close() = 0;       ///< false: it asks first, and closes itself when wants_to_close()
    virtual bool wants_to_close() = 0;  ///< the answer was yes
    virtual bool is_busy() = 0;  ///< asked once per frame: something goes on beside the picture, the panels show it
    virtual std::string take_notice() = 0;  ///< a one-time message; empty: none

    /// Before each frame: may set the clock, start and stop it.
    virtual void steer(WindowClock& /*clock*/) {}
};

}  // namespace lightwalk
