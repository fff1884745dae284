// When a window draws: its panel until that has settled, its picture where something has changed it.
#pragma once
#include <string>

#include "common/window/display.h"
#include "common/window/overlay.h"

namespace lightwalk {

double steady_s();  ///< seconds of a clock that only goes forward

/// Decides when the picture is drawn, since a software rasteriser takes much longer for it than for the panel. Moving
/// the mouse draws none; panel actions do if the panel requests it, and one more follows at the end.
class Activity {
  public:
    explicit Activity(const Overlay& overlay) : overlay_(overlay) {}

    void note(const Input& input);
    void stay(double seconds);  ///< and the picture, too, is drawn again: something has changed it
    void stay_panel(double seconds);
    void begin_panel();
    void begin_picture();

    bool has_settled() const;  ///< the panel has
    bool picture_is_due(bool moves) const;
    bool is_still() const { return !last_picture_due_ && has_settled(); }  ///< nothing changes the picture

    static constexpr double settle_s = 0.2;  ///< drawn for so long after something happened

  private:
    const Overlay& overlay_;
    double until_ = 0;
    int frames_due_ = 0;
    bool picture_due_ = true, last_picture_due_ = true;  ///< now; once the panel has settled
};

/// A message of the window, shown for a while.
class Notice {
  public:
    static constexpr double shown_s = 5.0;
    void tell(const std::string& text) { text_ = text, until_ = steady_s() + shown_s; }
    const std::string& text() const { return text_; }
    bool has_ended();  ///< true once

  private:
    std::string text_;
    double until_ = 0;
};

}  // namespace lightwalk
