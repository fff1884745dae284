#include "common/window/event_log.h"

#include <imgui.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>

namespace lightwalk {
namespace {

bool wanted() {
    static const bool on = [] {
        const char* given = std::getenv("LIGHTWALK_LOG");
        return given && std::string_view(given) == "1";
    }();
    return on;
}

}  // namespace

void log_event(const std::string& text) {
    if (!wanted()) return;
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
}

void log_place(const std::string& name) {
    if (!wanted()) return;
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    char place[64];
    std::snprintf(place, sizeof place, "%.0f %.0f %.0f %.0f", double(a.x), double(a.y), double(b.x), double(b.y));
    static std::map<std::string, std::string> last;
    std::string& before = last[name];
    if (before == place) return;
    before = place;
    log_event("place " + name + " " + place);
}

}  // namespace lightwalk
