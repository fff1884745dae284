#include "common/window/status_line.h"

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

const std::vector<std::string> camera_words{"drag: orbit", "wheel: zoom", "Shift+drag: pan",
                                            "right button + WASD QE: fly"};

// Whole words only, from the first on.
void draw_words(const std::vector<std::string>& words, float right) {
    const float gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    float used = ImGui::GetCursorPosX();
    for (size_t i = 0; i < words.size(); ++i) {
        const float width = ImGui::CalcTextSize(words[i].c_str()).x;
        if (used + width > right) break;
        if (i > 0) ImGui::SameLine(0.0f, gap);
        ImGui::TextUnformatted(words[i].c_str());
        used += width + gap;
    }
}

}  // namespace

uint32_t StatusLine::height_px(float scale, uint32_t window_height) {
    const float wanted = static_cast<float>(height) * scale;
    return wanted < 0.2f * static_cast<float>(window_height) ? static_cast<uint32_t>(wanted) : 0;
}

void StatusLine::draw(const Area& picture, const std::vector<std::string>& mouse,
                      const std::vector<std::string>& pixel) {
    const float top = static_cast<float>(picture.corner.y + picture.size.y), width = static_cast<float>(picture.size.x);
    const float below = ImGui::GetIO().DisplaySize.y - top;
    if (below < 1.0f) return;
    ImGui::SetNextWindowPos({static_cast<float>(picture.corner.x), top});
    ImGui::SetNextWindowSize({width, below});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, 2.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1.0f});
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const float right = width - ImGui::GetStyle().WindowPadding.x;
    ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
    draw_words(mouse.empty() ? camera_words : mouse, right);
    ImGui::PopStyleColor();
    draw_words(pixel, right);
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace lightwalk
