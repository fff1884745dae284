#include "common/window/cost_graph.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/window/activity.h"
#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {

void CostGraph::note(const std::vector<PassTime>& times, double frame_ms) {
    double total = 0.0;
    for (const PassTime& one : times) total += one.gpu_ms;
    costs_.push_back({steady_s(), total, frame_ms});
    while (costs_.front().at_s < costs_.back().at_s - seconds) costs_.pop_front();
}

// Time ends at the last picture: at rest the graph stands still.
void CostGraph::draw() const {
    if (costs_.empty()) return;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 2.6f * ImGui::GetTextLineHeight()};
    ImGui::InvisibleButton("cost", size);
    log_place("cost");
    double most = 0.0;
    for (const Cost& cost : costs_) most = std::max({most, cost.gpu_ms, cost.frame_ms});
    most = std::max(most, 1e-3);  // of a first picture whose times are not known yet
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The last %.0f s, up to %.2f ms: all passes (blue) and the frame (grey)", seconds, most);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
    const auto x_of = [&](double at_s) {
        const double share = (at_s - costs_.back().at_s) / seconds + 1.0;
        return corner.x + static_cast<float>(share) * size.x;
    };
    const auto y_of = [&](double ms) { return corner.y + size.y * (1.0f - static_cast<float>(ms / most)); };
    const float bottom = corner.y + size.y;
    for (size_t i = 0; i < costs_.size(); ++i) {
        const float right = x_of(costs_[i].at_s), left = i ? x_of(costs_[i - 1].at_s) : right - 2.0f;
        const ImVec2 from{std::max(left, corner.x), y_of(costs_[i].frame_ms)};
        list.AddRectFilled(from, {right, bottom}, ImGui::GetColorU32({0.32f, 0.35f, 0.40f, 1.0f}));
        list.AddRectFilled({from.x, y_of(costs_[i].gpu_ms)}, {right, bottom}, ImGui::GetColorU32(reference_color));
    }
    const std::string scale = fmt::format("{:.{}f} ms", most, most < 10.0 ? 2 : 0);
    const ImVec2 text = ImGui::CalcTextSize(scale.c_str());
    list.AddRectFilled(corner, {corner.x + text.x + 8.0f, corner.y + text.y + 2.0f},
                       ImGui::GetColorU32({0.05f, 0.06f, 0.07f, 0.75f}), 3.0f);  // the blue is as bright as the number
    list.AddText({corner.x + 4.0f, corner.y + 1.0f}, ImGui::GetColorU32(ImGuiCol_Text), scale.c_str());
}

}  // namespace lightwalk
