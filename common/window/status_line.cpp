#include "common/window/status_line.h"

#include <algorithm>

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

const std::vector<std::string> camera_words{"drag: orbit", "wheel: zoom", "Shift+drag: pan",
                                            "right button + WASD QE: fly"};
const std::vector<std::string> pixel_words{"point at the picture: object, material, linear colour, depth"};

// Whole words only, from the first on.
void draw_words(const std::vector<std::string>& words, float right) {
    const float gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    float used = ImGui::GetCursorPosX();
    for (size_t i = 0; i < words.size(); ++i) {
        const float width = ImGui::CalcTextSize(words[i].c_str()).x;
        if (used + width > right) break;
        if (i > 0) ImGui::SameLine(0.0f, gap);
        ImGui::TextUnformatted(words[i].c_str());
        log_place("status." + words[i]);
        used += width + gap;
    }
}

}  // namespace

uint32_t StatusLine::height_px(float scale, uint32_t window_height) {
    const float wanted = static_cast<float>(height) * scale;
    return wanted < 0.2f * static_cast<float>(window_height) ? static_cast<uint32_t>(wanted) : 0;
}

void StatusLine::draw(const Area& picture, float scale, const std::string& notice,
                      const std::vector<std::string>& mouse, const std::vector<std::string>& pixel) {
    const float top = static_cast<float>(picture.corner.y + picture.size.y), width = static_cast<float>(picture.size.x);
    const auto below = static_cast<float>(height_px(scale, static_cast<uint32_t>(ImGui::GetIO().DisplaySize.y)));
    const float padding = ImGui::GetStyle().WindowPadding.x, right = width - padding;
    const float lines = notice.empty() ? 0.0f : ImGui::CalcTextSize(notice.c_str(), nullptr, false, right - padding).y;
    const float high = std::max(below, lines > 0.0f ? lines + 4.0f * scale : 0.0f);
    if (high < 1.0f) return;
    ImGui::SetNextWindowPos({static_cast<float>(picture.corner.x), top + below - high});
    ImGui::SetNextWindowSize({width, high});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, 2.0f * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1.0f});
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (notice.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        draw_words(mouse.empty() ? camera_words : mouse, right);
        ImGui::PopStyleColor();
    } else {
        ImGui::PushTextWrapPos(right);
        ImGui::TextUnformatted(notice.c_str());
        ImGui::PopTextWrapPos();
        log_place("notice");
    }
    if (lines < 1.5f * ImGui::GetTextLineHeight()) {
        ImGui::PushStyleColor(ImGuiCol_Text, pixel.empty() ? quiet_color : ImGui::GetStyleColorVec4(ImGuiCol_Text));
        draw_words(pixel.empty() ? pixel_words : pixel, right);
        ImGui::PopStyleColor();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace lightwalk
