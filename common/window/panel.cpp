#include "common/window/panel.h"

#include <algorithm>

#include "common/base/exercise.h"
#include "common/window/event_log.h"
#include "common/window/knob_widgets.h"
#include "common/window/titles.h"

namespace lightwalk {
namespace {

bool section(const char* name) {
    ImGui::PushStyleColor(ImGuiCol_Header, {0.115f, 0.13f, 0.155f, 1.0f});
    const bool open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleColor();
    log_place(std::string("section.") + name);
    return open;
}

void help_on_hover(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

// One of two: a pair of buttons of which one is lit.
bool half_switch(const char* label, bool lit, const ImVec4& color, float width) {
    const ImVec4 dark{0.08f, 0.09f, 0.10f, 1.0f};
    if (lit) {
        for (const ImGuiCol which : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
            ImGui::PushStyleColor(which, color);
        ImGui::PushStyleColor(ImGuiCol_Text, dark);
    }
    const bool clicked = ImGui::Button(label, {width, 0.0f});
    if (lit) ImGui::PopStyleColor(4);
    return clicked && !lit;
}

// The exercise's mine | reference. True where it was switched.
bool exercise_row(const std::string& id) {
    const float padding = 2.0f * ImGui::GetStyle().FramePadding.x, gap = 2.0f;
    const float mine_width = ImGui::CalcTextSize("mine").x + padding;
    const float reference_width = ImGui::CalcTextSize("reference").x + padding;
    ImGui::PushID(id.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(id.c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - mine_width - reference_width - gap);
    bool switched = false;
    if (!Exercises::has_solution(id)) {
        ImGui::TextColored(mine_color, "mine");
        help_on_hover("This tree has no reference to switch to.");
    } else {
        const bool reference = Exercises::uses_solution(id);
        const bool mine = half_switch("mine", !reference, mine_color, mine_width);
        log_place("mine." + id);
        ImGui::SameLine(0.0f, gap);
        switched = half_switch("reference", reference, reference_color, reference_width) || mine;
        log_place("reference." + id);
        if (switched) Exercises::set(id, !reference);
    }
    ImGui::PopID();
    return switched;
}

}  // namespace

Panel::Panel(const Chapter& chapter, const Overlay& overlay)
    : overlay_(overlay), title_(chapter.name.substr(0, 2) + "  " + chapter_title(chapter.name)) {}

int Panel::width(float scale) const { return visible ? static_cast<int>(default_width * scale) : 0; }

Requests Panel::draw(PanelState& state, float scale) {
    Requests requests;
    if (!visible) return requests;
    const float left = ImGui::GetIO().DisplaySize.x - static_cast<float>(width(scale));
    ImGui::SetNextWindowPos({left, 0.0f});
    ImGui::SetNextWindowSize({static_cast<float>(width(scale)), ImGui::GetIO().DisplaySize.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    ImGui::PushFont(overlay_.large);
    ImGui::TextUnformatted(title_.c_str());
    ImGui::PopFont();
    if (section("Exercises")) exercises(state, requests);
    if (!state.chapter.all_knobs().empty() && section("Knobs")) knobs(state, requests);
    if (section("Look at")) look(state, requests);
    if (section("GPU time")) times(state);
    footer(state, requests);
    ImGui::End();
    return requests;
}

void Panel::exercises(PanelState& state, Requests& requests) {
    const auto rows = [&](const std::vector<std::string>& ids) {
        for (const std::string& id : ids) {
            if (!exercise_row(id)) continue;
            requests.changed = true;
            log_event("toggle " + id + " " + (Exercises::uses_solution(id) ? "reference" : "mine"));
        }
    };
    const auto own = own_exercises(state.chapter), earlier = earlier_exercises(state.chapter);
    rows(own);
    if (own.empty()) ImGui::TextColored(quiet_color, "none in this chapter");
    const bool handout = !any_reference_exists(own) && !any_reference_exists(earlier);
    if (handout) ImGui::TextColored(quiet_color, "This tree is a handout: it has no reference.");
    if (!handout && ImGui::Button("switch all   F2", {-1.0f, 0.0f})) requests.all_toggles = true;
    if (!earlier.empty() && ImGui::TreeNode("earlier", "of earlier chapters (%zu)   Shift+F2", earlier.size())) {
        rows(earlier);
        ImGui::TreePop();
    }
    if (!handout) split(state, requests);
}

void Panel::knobs(PanelState& state, Requests& requests) {
    for (KnobBase* knob : state.chapter.all_knobs())
        if (knob_widget(*knob)) {
            requests.changed = true;
            log_event("knob " + knob->name + " " + knob->text());
        }
}

void Panel::split(PanelState& state, Requests& requests) {
    bool on = state.split.on();
    if (ImGui::Checkbox("mine beside reference   F3", &on)) requests.split = true;
    log_place("split");
    help_on_hover(
        "Mine on the left, as the switches say; all of mine where they all say reference.\n"
        "The reference on the right. Drag the line between them.");
    if (!state.split.on()) return;
    if (const auto& difference = state.split.difference) {
        ImGui::Text("FLIP %.4f", difference->flip_mean);
        ImGui::SameLine();
        ImGui::TextColored(quiet_color, difference->shrink == 1 ? "mean error, 0 to 1" : "mean, at 1/%d of the size",
                           difference->shrink);
        help_on_hover(
            "How visible the difference is to someone who flips between the two pictures.\n"
            "Computed when the picture stands still.");
    } else {
        ImGui::TextColored(quiet_color, "FLIP: when the picture stands still");
    }
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

void Panel::times(PanelState& state) {
    const bool same = std::equal(smooth_.begin(), smooth_.end(), state.times.begin(), state.times.end(),
                                 [](const PassTime& a, const PassTime& b) { return a.name == b.name; });
    averaged_ = same ? averaged_ + 1 : 0;
    if (!same) smooth_ = state.times;
    // The average over about ten frames: a figure that can be read while it changes. The first frame only warms up.
    const double weight = std::max(0.1, 1.0 / std::max(averaged_, 1));
    double total = 0;
    ImGui::BeginTable("times", 3, ImGuiTableFlags_SizingFixedFit);
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    const auto row = [](const char* name, const char* stage, double ms) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(name);
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
    ImGui::PushTextWrapPos();
    for (const std::string& line : state.chapter.status()) ImGui::TextUnformatted(line.c_str());
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
                       "drag: orbit   Shift+drag: pan   wheel: zoom\n"
                       "right button + WASD QE: fly   Shift: faster\n"
                       "F: whole scene   Home: its own camera\n"
                       "H: hide this   Esc: close");
}

}  // namespace lightwalk
