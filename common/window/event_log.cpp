#include "common/window/event_log.h"

#include <imgui.h>
#include <imgui_internal.h>  // the room of a window

#include <cmath>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

namespace lightwalk {
namespace {

bool wanted = false, layout_wanted = false;

// Of this frame and the one before.
std::vector<std::string> widgets_drawn, widgets_before;

void note_layout(const std::string& name, const std::string& text) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax(),
                 size = text.empty() ? ImVec2() : ImGui::CalcTextSize(text.c_str(), nullptr, true);
    const auto in_tabs = [](auto... numbers) {
        std::string line;
        ((line += "\t" + std::to_string(std::lround(numbers))), ...);
        return line;
    };
    widgets_drawn.push_back(
        name + "\t" + window.Name +
        in_tabs(a.x, a.y, b.x, b.y, window.WorkRect.Min.x, window.WorkRect.Max.x, size.x, ImGui::GetFontSize()) + "\t" +
        text);
}

}  // namespace

void log_events(const std::string& what) {
    wanted = !what.empty();
    layout_wanted = what == "layout";
}

void log_layout() {
    if (!layout_wanted) return;
    if (widgets_drawn != widgets_before) {
        std::printf("layout %zu\n", widgets_drawn.size());
        for (const std::string& line : widgets_drawn) std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }
    widgets_before = std::exchange(widgets_drawn, {});
}

void log_event(const std::string& text) {
    if (!wanted) return;
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
}

void log_place(const std::string& name, const std::string& text) {
    if (!wanted) return;
    if (layout_wanted) note_layout(name, text);
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
    log_layout();
    static uint64_t count = 0;
    log_event("frame " + std::to_string(++count) + (keys_wait ? " keys" : "") +
              (ImGui::GetIO().WantTextInput ? " text" : "") + (picture_is_new ? " picture" : ""));
}

}  // namespace lightwalk
