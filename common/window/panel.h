// The panel beside the picture, and text over the picture.
#pragma once
#include <deque>
#include <vector>

#include "common/gpu/frame.h"
#include "common/window/blit.h"
#include "common/window/exercise_checks.h"
#include "common/window/knob_sections.h"
#include "common/window/overlay.h"
#include "common/window/split_view.h"

namespace lightwalk {

class CostGraph {
  public:
    static constexpr double seconds = 10.0;

    void note(const std::vector<PassTime>& times, double frame_ms);  ///< a new picture's
    void draw() const;

  private:
    struct Cost {
        double at_s, gpu_ms, frame_ms;
    };
    std::deque<Cost> costs_;
};

/// Requests by panel and keys.
struct Requests {
    bool reload = false, screenshot = false, capture = false, save = false, home = false, frame_scene = false,
         all_toggles = false;
    bool earlier_toggles = false;  ///< all toggles, and those of earlier chapters
    bool split = false, clock = false, panel = false, passes = false, changed = false;
    std::string lesson;  ///< chapter or exercise of the lesson to show
    std::string check;   ///< the exercise to check
};

/// The state that the panel shows and changes.
struct PanelState {
    Chapter& chapter;
    const Device& device;
    SplitView& split;
    Look& look;
    const ExerciseChecks& checks;
    AutoChoices& automatic;
    std::vector<std::string> outputs;  ///< names of viewable outputs
    std::vector<PassTime> times;       ///< of the last picture
    bool picture_is_new = true;        ///< false: only the panel is drawn again
    double frame_ms = 0;               ///< from one picture to the next, wall clock
    bool clock_runs = false;
    float time_s = 0;
    glm::uvec2 picture{0};              ///< pixels
    std::vector<std::string> errors{};  ///< the picture is the last one that worked
};

/// A text cut to fit the screen: a compiler may quote a line of megabytes.
std::string shortened(const std::string& text);

/// The text, or its beginning and `end` where it is wider.
std::string cut_text(const std::string& text, float width, const char* end = "...");

/// A tooltip over the widget drawn last.
void help_on_hover(const char* text);

class Panel {
  public:
    Panel(const Chapter& chapter, const Overlay& overlay);

    static constexpr int default_width = 340;  ///< pixels at scale 1
    bool visible = true;

    /// Of the right edge of the window, in pixels; 0 while it is hidden, and in a window in which it would cover most
    /// of the picture.
    int width(float scale, uint32_t window_width) const;

    Requests draw(PanelState& state, float scale);

    /// Over the picture, where the panel, whose lower end has the errors, is hidden.
    void draw_errors_instead(const PanelState& state, const Area& picture, float scale);

    /// The divider to drag and the names of the two sides. True if it was moved.
    bool draw_divider(SplitView& split, const Area& picture);

  private:
    void exercises(PanelState& state, Requests& requests);
    void split(PanelState& state, Requests& requests);
    void look(PanelState& state, Requests& requests);
    void times(PanelState& state, Requests& requests);
    void footer(PanelState& state, Requests& requests);
    /// In a window of this width at most: all text, or most_px with a scrollbar.
    float errors_px(const std::vector<std::string>& errors, float width_px, float most_px) const;
    void draw_errors(const std::vector<std::string>& errors, ImVec2 corner, ImVec2 size) const;
    const Overlay& overlay_;
    std::string title_;
    KnobSections knobs_;
    std::vector<PassTime> smooth_;
    int averaged_ = 0;  ///< frames since the passes changed
    CostGraph cost_;
};

}  // namespace lightwalk
