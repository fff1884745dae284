#include "common/window/activity.h"

#include <algorithm>
#include <chrono>

namespace lightwalk {
namespace {

constexpr int settle_frames = 6;  // a field that is asked for has the keyboard in the fifth

}  // namespace

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void Activity::note(const Input& input) {
    if (!input.happened) return;
    stay_panel(settle_s);
    frames_due_ = settle_frames;
    if (!input.acted) return;
    const ImGuiIO& io = ImGui::GetIO();
    last_picture_due_ = true;
    if (!io.WantCaptureMouse && !io.WantTextInput) picture_due_ = true;
}

void Activity::stay(double seconds) {
    stay_panel(seconds);
    picture_due_ = last_picture_due_ = true;
}

void Activity::stay_panel(double seconds) { until_ = std::max(until_, steady_s() + seconds); }

void Activity::begin_panel() { frames_due_ = std::max(frames_due_ - 1, 0); }

void Activity::begin_picture() {
    picture_due_ = false;
    if (has_settled()) last_picture_due_ = false;
}

bool Activity::has_settled() const { return steady_s() > until_ && frames_due_ == 0 && !overlay_.input_is_left(); }

// A moving picture may show the previous frame (screens within screens), so it needs further frames.
bool Activity::picture_is_due(bool moves) const {
    return picture_due_ || (last_picture_due_ && (has_settled() || moves));
}

bool Notice::has_ended() {
    if (text_.empty() || steady_s() <= until_) return false;
    text_.clear();
    return true;
}

}  // namespace lightwalk
