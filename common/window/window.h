// A chapter in a window, while someone works on it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/app/chapter.h"
#include "common/app/options.h"
#include "common/window/activity.h"
#include "common/window/blit.h"
#include "common/window/camera_control.h"
#include "common/window/lesson_pages.h"
#include "common/window/live_chapter.h"
#include "common/window/panel.h"
#include "common/window/sound_player.h"
#include "common/window/window_picture.h"
#include "common/window/window_tool.h"

namespace lightwalk {

struct StatusLine {
    static constexpr int height = 46;  ///< two lines, in pixels at scale 1

    /// 0 in a window in which it would take much of the picture.
    static uint32_t height_px(float scale, uint32_t window_height);

    /// As many words as have room. No `mouse`: it moves the camera. A `notice` takes their place, and part of the picture
    /// only where it has more lines than these.
    static void draw(const Area& picture, float scale, const std::string& notice, const std::vector<std::string>& mouse,
                     const std::vector<std::string>& pixel);
};

class SceneSaver {
  public:
    SceneSaver(const Chapter& chapter, std::filesystem::path scene, Notice& notice);

    /// Saves a person's scene file and preserves the rest of it; if it changed since it was read, or another file
    /// exists there, the key must be pressed twice.
    void save();
    void remember();  ///< the file was read again

  private:
    const Chapter& chapter_;
    std::filesystem::path scene_;
    Notice& notice_;
    uint64_t read_ = 0;         ///< hash of the scene file as it was read or saved
    uint64_t saved_ = 0;        ///< of the file that was saved beside it
    double confirm_until_ = 0;  ///< until then it is saved without asking
};

/// Makes the device in `gpu`, which must outlive the chapter, and runs it in a window, which makes a second chapter
/// where two versions are shown side by side. Returns the exit code.
int run_window(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu, const MakeChapter& make,
               const Loading& loading);

/// Names what is prepared behind the window's title, where the picture is late: nothing else can be drawn meanwhile.
class PreparingTitle {
  public:
    explicit PreparingTitle(Display& display);
    ~PreparingTitle();
    PreparingTitle(const PreparingTitle&) = delete;
    void begin_picture();
    void end_picture();

  private:
    Display& display_;
    double late_s_ = 0;  ///< steady_s() from which on it is named
    bool said_ = false;
};

class Window {
  public:
    /// `scene` is loaded already.
    Window(const Options& options, LiveChapter& live, Gpu& gpu, Display& display, const MakeChapter& make,
           std::filesystem::path scene, PreparingTitle& preparing);

    /// Until it is closed.
    void run();

  private:
    void handle_keys(const Input& input, Requests& requests);
    void ask_tool();
    void obey(const Requests& requests);
    void reload();
    void toggle_all(bool earlier_too);
    void take_screenshot();
    void write_capture(Capture& capture);
    void switch_split();
    void choose_automatically();
    void watch_files();
    void watch_programs();
    void draw();
    void draw_picture();
    bool refines() const;         ///< the picture rests, and samples are missing
    bool can_show();              ///< the window has a size
    bool picture_is_due() const;  ///< false: the panel is drawn beside the picture that is there
    bool is_still() const;        ///< nothing is drawn: neither time nor input changes the picture
    Requests build_panel(bool picture_is_new);
    std::vector<std::string> errors();
    void compare_when_still();
    Area picture_area() const;  ///< of the window: beside the panels, above the status line
    glm::uvec2 picture_size() const { return picture_area().size; }
    glm::vec2 on_picture(glm::vec2 cursor) const;  ///< pixels from its corner
    void draw_status();

    const Options& options_;
    LiveChapter& live_;
    Chapter& chapter_;
    WindowTool* const tool_;  ///< the chapter, or null
    Gpu& gpu_;
    Display& display_;
    PreparingTitle& preparing_;
    Swapchain swapchain_;
    Overlay overlay_;
    Activity activity_;
    Notice notice_;
    SceneSaver saver_;
    CameraMouse mouse_;
    Panel panel_;
    WindowPicture picture_;
    ExerciseChecks checks_;
    AutoChoices automatic_;
    LessonPages lessons_;
    SoundPlayer sound_;
    PixelProbe probe_;
    glm::vec2 cursor_{-1.0f};  ///< pixels of the picture
    Frame screen_;             ///< the window's own passes, not the chapter's
    WindowClock clock_;
    bool close_ = false;
    bool rests_ = false;  ///< until something happens
    int drawn_ = 0;       ///< frames
    double next_watch_ = 0, last_draw_ = 0, frame_ms_ = 0;
    std::string logged_errors_;
    bool capture_next_ = false;  ///< for RenderDoc
};

}  // namespace lightwalk
