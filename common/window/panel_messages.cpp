#include <algorithm>
#include <cmath>

#include "common/window/event_log.h"
#include "common/window/panel.h"

namespace lightwalk {
namespace {

constexpr ImGuiWindowFlags over_picture = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                          ImGuiWindowFlags_NoFocusOnAppearing;

void side_name(const char* text, const ImVec4& color, ImVec2 corner) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({corner.x, corner.y}, {corner.x + size.x + 12.0f, corner.y + size.y + 8.0f},
                       ImGui::GetColorU32({0.05f, 0.06f, 0.07f, 0.75f}), 3.0f);
    list.AddText({corner.x + 6.0f, corner.y + 4.0f}, ImGui::GetColorU32(color), text);
}

}  // namespace

// ImGui counts vertices with 16 bits.
std::string shortened(const std::string& text) {
    constexpr size_t most_of_line = 400, most = 4000;
    std::string result;
    for (size_t begin = 0; begin < text.size() && result.size() < most;) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const bool cut = end - begin > most_of_line;
        result += text.substr(begin, cut ? most_of_line : end - begin) + (cut ? " ...\n" : "\n");
        begin = end + 1;
    }
    return result.substr(0, std::max<size_t>(result.size(), 1) - 1);
}

float Panel::errors_px(const std::vector<std::string>& errors, float width_px, float most_px) const {
    if (errors.empty()) return 0.0f;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float wrap = width_px - 2.0f * style.WindowPadding.x - style.ScrollbarSize;
    float sum = 2.0f * style.WindowPadding.y + ImGui::GetTextLineHeightWithSpacing();
    ImGui::PushFont(overlay_.mono);
    for (const std::string& error : errors)
        sum += ImGui::CalcTextSize(shortened(error).c_str(), nullptr, false, wrap).y + style.ItemSpacing.y;
    ImGui::PopFont();
    return std::min(std::ceil(sum), most_px);
}

void Panel::draw_errors(const std::vector<std::string>& errors, ImVec2 corner, ImVec2 size) const {
    if (errors.empty()) return;
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.16f, 0.03f, 0.03f, 1.0f});
    ImGui::Begin("errors", nullptr, over_picture & ~ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::PushFont(overlay_.mono);
    ImGui::PushStyleColor(ImGuiCol_Text, error_color);
    ImGui::PushTextWrapPos();
    for (const std::string& error : errors) ImGui::TextUnformatted(shortened(error).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::TextColored(quiet_color, "Drawn with the last version that compiled; without one, its pass draws nothing.");
    log_place("errors");
    ImGui::End();
}

void Panel::draw_errors_instead(const PanelState& state, const Area& picture, float scale) {
    if (width(scale, static_cast<uint32_t>(ImGui::GetIO().DisplaySize.x)) > 0) return;
    const float width_px = static_cast<float>(picture.size.x), height_px = static_cast<float>(picture.size.y),
                own_px = errors_px(state.errors, width_px, 0.6f * height_px);
    draw_errors(state.errors, {static_cast<float>(picture.corner.x), height_px - own_px}, {width_px, own_px});
}

bool Panel::draw_divider(SplitView& split, const Area& picture) {
    const float left = static_cast<float>(picture.corner.x), width = static_cast<float>(picture.size.x),
                height = static_cast<float>(picture.size.y);
    const float grip = 14.0f, x = left + split.divider * width;
    ImGui::SetNextWindowPos({x - 0.5f * grip, 0.0f});
    ImGui::SetNextWindowSize({grip, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::Begin("divider", nullptr, over_picture | ImGuiWindowFlags_NoBackground);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("grip", {grip, height});
    log_place("divider");
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (held) split.divider = glm::clamp((ImGui::GetIO().MousePos.x - left) / width, 0.02f, 0.98f);
    ImGui::End();
    const float line = left + split.divider * width;
    ImGui::GetBackgroundDrawList()->AddLine({line, 0.0f}, {line, height},
                                            ImGui::GetColorU32({1.0f, 1.0f, 1.0f, held ? 1.0f : 0.75f}), 2.0f);
    const float name_width = ImGui::CalcTextSize("mine").x + 12.0f;
    side_name("mine", mine_color, {line - name_width - 10.0f, 8.0f});
    side_name("reference", reference_color, {line + 10.0f, 8.0f});
    return held;
}

}  // namespace lightwalk
