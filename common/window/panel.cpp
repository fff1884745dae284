#include "common/window/panel.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/window/activity.h"
#include "common/window/event_log.h"
#include "common/window/lesson_pages.h"
#include "common/window/overlay.h"

namespace lightwalk {

void help_on_hover(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

std::string cut_text(const std::string& text, float width, const char* end) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const float room = width - ImGui::CalcTextSize(end).x;
    const char* rest = text.c_str();
    ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(room, 1.0f), 0.0f, rest, nullptr, &rest);
    return text.substr(0, static_cast<size_t>(rest - text.c_str())) + end;
}

namespace {

bool section(const char* name) {
    ImGui::PushStyleColor(ImGuiCol_Header, {0.115f, 0.13f, 0.155f, 1.0f});
    const bool open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleColor();
    log_place(std::string("section.") + name);
    return open;
}

}  // namespace

Panel::Panel(const Chapter& chapter, const Overlay& overlay)
    : overlay_(overlay), title_(chapter.name.substr(0, 2) + "  " + chapter_title(chapter.name)), knobs_(chapter.name) {}

int Panel::width(float scale, uint32_t window_width) const {
    const float wanted = default_width * scale;
    return visible && wanted < 0.6f * static_cast<float>(window_width) ? static_cast<int>(wanted) : 0;
}

Requests Panel::draw(PanelState& state, float scale) {
    Requests requests;
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    const float own = static_cast<float>(width(scale, static_cast<uint32_t>(whole.x)));
    if (own == 0.0f) return requests;
    const float errors = errors_px(state.errors, own, 0.4f * whole.y);
    draw_errors(state.errors, {whole.x - own, whole.y - errors}, {own, errors});
    ImGui::SetNextWindowPos({whole.x - own, 0.0f});
    ImGui::SetNextWindowSize({own, whole.y - errors});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    ImGui::PushFont(overlay_.large);
    ImGui::TextWrapped("%s", title_.c_str());
    ImGui::PopFont();
    if (ImGui::Button("lesson", {-1.0f, 0.0f})) requests.lesson = state.chapter.name;
    log_place("lesson");
    help_on_hover("The chapter's lesson as a page, in the browser");
    if (section("Exercises")) exercises(state, requests);
    if (!state.chapter.all_knobs().empty() && section("Knobs") && knobs_.draw(state.chapter, smooth_, state.automatic))
        requests.changed = true;
    if (section("Look at")) look(state, requests);
    if (section("GPU time")) times(state, requests);
    footer(state, requests);
    ImGui::End();
    return requests;
}

void Panel::look(PanelState& state, Requests& requests) {
    Look& look = state.look;
    const Look before = look;
    constexpr const char* picture = "the picture";
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##look", look.output.empty() ? picture : look.output.c_str());
    log_place("look");
    if (open) {
        if (ImGui::Selectable(picture, look.output.empty())) look.output.clear();
        log_place("look.the picture");
        for (const std::string& name : state.outputs) {
            if (ImGui::Selectable(name.c_str(), name == look.output)) look.output = name;
            log_place("look." + name);
        }
        ImGui::EndCombo();
    }
    if (!look.output.empty()) {
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
        ImGui::SliderFloat("##stops", &look.stops, -8.0f, 8.0f, "%+.1f stops");
        help_on_hover("Brighter by powers of two. NaN is magenta, infinity cyan.");
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::Combo("##channel", &look.channel, "all\0red\0green\0blue\0alpha\0");
    }
    if (look.output == before.output && look.stops == before.stops && look.channel == before.channel) return;
    requests.changed = true;
    if (look.output != before.output) log_event("look " + (look.output.empty() ? picture : look.output));
}

void Panel::times(PanelState& state, Requests& requests) {
    const bool same = std::equal(smooth_.begin(), smooth_.end(), state.times.begin(), state.times.end(),
                                 [](const PassTime& a, const PassTime& b) { return a.name == b.name; });
    averaged_ = same ? averaged_ + state.picture_is_new : 0;
    if (!same) smooth_ = state.times;
    // The average over about ten frames: a figure that can be read while it changes. The first frame only warms up.
    const double weight = state.picture_is_new ? std::max(0.1, 1.0 / std::max(averaged_, 1)) : 0.0;
    if (state.picture_is_new) cost_.note(state.times, state.frame_ms);
    cost_.draw();
    double total = 0;
    ImGui::BeginTable("times", 3, ImGuiTableFlags_SizingFixedFit);
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    auto row = [count = 0](const char* name, const char* stage, double ms) mutable {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(name);
        log_place(fmt::format("time.{}", count++));
        ImGui::TableNextColumn();
        ImGui::TextColored(quiet_color, "%s", stage);
        ImGui::TableNextColumn();
        ImGui::Text("%7.2f ms", ms);
    };
    for (size_t i = 0; i < smooth_.size(); ++i) {
        smooth_[i].gpu_ms += weight * (state.times[i].gpu_ms - smooth_[i].gpu_ms);
        row(smooth_[i].name.c_str(), smooth_[i].stage.c_str(), smooth_[i].gpu_ms);
        total += smooth_[i].gpu_ms;
    }
    row("all passes", "", total);
    row("frame", "wall clock", state.frame_ms);
    ImGui::EndTable();
    if (ImGui::Button("passes as a graph", {-1.0f, 0.0f})) requests.passes = true;
    log_place("button.passes");
    help_on_hover("F6: the passes below the picture, with an image of each target");
    ImGui::PushTextWrapPos();
    for (const std::string& line : state.chapter.all_status()) ImGui::TextUnformatted(line.c_str());
    ImGui::TextColored(quiet_color, "%zu triangles, %u×%u pixels", state.chapter.scene.triangle_count(),
                       state.picture.x, state.picture.y);
    ImGui::TextColored(quiet_color, "%s%s", state.device.info.name.c_str(),
                       state.device.software() ? " (software: CPU time)" : "");
    ImGui::TextColored(quiet_color, "%s", state.device.info.driver.c_str());
    ImGui::PopTextWrapPos();
}

void Panel::footer(PanelState& state, Requests& requests) {
    ImGui::Separator();
    const float width = (ImGui::GetContentRegionAvail().x - 3.0f * ImGui::GetStyle().ItemSpacing.x) / 4.0f;
    const auto button = [&](const char* label, const char* help, bool& request) {
        if (ImGui::Button(label, {width, 0.0f})) request = true;
        log_place(std::string("button.") + label);
        help_on_hover(help);
    };
    button("Reload", "F5: the scene and all shaders from disk", requests.reload);
    ImGui::SameLine();
    button("Picture", "F12: the picture as a PNG in the current folder", requests.screenshot);
    ImGui::SameLine();
    button("Save", "Ctrl+S: the scene with camera and knobs", requests.save);
    ImGui::SameLine();
    button(state.clock_runs ? "Stop" : "Run", "Space: the chapter's clock", requests.clock);
    if (state.clock_runs || state.time_s != 0.0f)
        ImGui::TextColored(quiet_color, "clock at %.1f s", static_cast<double>(state.time_s));
    ImGui::TextColored(quiet_color,
                       "F: whole scene   Home: its own camera\n"
                       "F6: passes   H: hide this   Esc: close");
}

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
