#include "common/window/event_log.h"

#include <imgui.h>

#include <cstdio>
#include <map>

namespace lightwalk {
namespace {

bool wanted = false;

}  // namespace

void log_events(bool on) { wanted = on; }

void log_event(const std::string& text) {
    if (!wanted) return;
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
}

void log_place(const std::string& name) {
    if (!wanted) return;
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    char place[64];
    std::snprintf(place, sizeof place, "%.0f %.0f %.0f %.0f", double(a.x), double(a.y), double(b.x), double(b.y));
    static std::map<std::string, std::string> last;
    std::string& before = last[name];
    if (before == place) return;
    before = place;
    log_event("place " + name + " " + place);
}

void log_mouse() {
    if (!wanted) return;
    const ImGuiIO& io = ImGui::GetIO();
    static float wheel = 0.0f;
    wheel += io.MouseWheel;
    int buttons = 0;
    for (int i = 0; i < 3; ++i) buttons |= int(io.MouseDown[i]) << i;
    // ImGui's "nowhere" is the most negative number, which is no place to print.
    const bool known = ImGui::IsMousePosValid();
    char mouse[64];
    std::snprintf(mouse, sizeof mouse, "mouse %.0f %.0f %d %.0f", double(known ? io.MousePos.x : -1.0f),
                  double(known ? io.MousePos.y : -1.0f), buttons, double(wheel));
    static std::string before;
    if (before == mouse) return;
    log_event(before = mouse);
}

void log_frame(bool keys_wait, bool picture_is_new) {
    if (!wanted) return;
    static uint64_t count = 0;
    log_event("frame " + std::to_string(++count) + (keys_wait ? " keys" : "") +
              (ImGui::GetIO().WantTextInput ? " text" : "") + (picture_is_new ? " picture" : ""));
}

}  // namespace lightwalk
