#include <map>

#include "common/base/exercise.h"
#include "common/window/event_log.h"
#include "common/window/exercise_checks.h"
#include "common/window/panel.h"

namespace lightwalk {
namespace {

constexpr float gap = 2.0f;

float width_of(const char* label) { return ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x; }

// One of two: a pair of buttons of which one is lit.
bool half_switch(const char* label, bool lit, const ImVec4& color) {
    const ImVec4 dark{0.08f, 0.09f, 0.10f, 1.0f};
    if (lit) {
        for (const ImGuiCol which : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
            ImGui::PushStyleColor(which, color);
        ImGui::PushStyleColor(ImGuiCol_Text, dark);
    }
    const bool clicked = ImGui::Button(label);
    if (lit) ImGui::PopStyleColor(4);
    return clicked && !lit;
}

// mine | reference. True if it was switched.
bool toggle(const std::string& id) {
    if (!Exercises::has_solution(id)) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(mine_color, "mine");
        help_on_hover("This tree has no reference to switch to.");
        return false;
    }
    const bool reference = Exercises::uses_solution(id);
    const bool mine = half_switch("mine", !reference, mine_color);
    log_place("mine." + id);
    ImGui::SameLine(0.0f, gap);
    const bool switched = half_switch("reference", reference, reference_color) || mine;
    log_place("reference." + id);
    if (switched) Exercises::set(id, !reference);
    return switched;
}

struct Verdict {
    const char* name;
    ImVec4 color;
};

Verdict verdict(const CheckVerdict& check) {
    switch (check.state) {
        case CheckVerdict::State::running:
            return {"checking ...", quiet_color};
        case CheckVerdict::State::passed:
            return {"solved", right_color};
        case CheckVerdict::State::open:
            return {"open", error_color};
        case CheckVerdict::State::invalid:
            return {"does not compile", error_color};
        default:
            return {"not checked", error_color};
    }
}

// Of an exercise that this window has not checked as it is.
Verdict verdict(const std::string& id) {
    if (!Exercises::compiles(id)) return {"does not compile", error_color};
    if (is_untouched(id)) return {"untouched", quiet_color};
    const std::optional<bool> solved = kept_verdict(id);
    return solved ? Verdict{*solved ? "solved" : "open", *solved ? right_color : error_color}
                  : Verdict{"not checked", quiet_color};
}

// The check's words, as high as needed but at most ten lines, and its hint in a fold.
void check_words(const std::string& id, const CheckVerdict& check) {
    if (check.words.empty() && check.hint.empty()) return;
    const bool open = ImGui::TreeNodeEx("what it says", ImGuiTreeNodeFlags_DefaultOpen);
    log_place("words." + id);
    if (!open) return;
    float& height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("height"), ImGui::GetTextLineHeight());
    ImGui::PushStyleColor(ImGuiCol_ChildBg, {0.055f, 0.062f, 0.075f, 1.0f});
    begin_padded_child("said", {0.0f, std::min(height, 10.5f * ImGui::GetTextLineHeight())});
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(shortened(check.words).c_str());
    if (!check.hint.empty()) {
        const bool told = ImGui::TreeNode("a hint");
        log_place("hint." + id);
        if (told) {
            ImGui::TextUnformatted(check.hint.c_str());
            ImGui::TreePop();
        }
    }
    ImGui::PopTextWrapPos();
    height = ImGui::GetCursorPosY() + ImGui::GetScrollY() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::TreePop();
}

void log_state(const std::string& id, const std::string& state) {
    static std::map<std::string, std::string> last;
    if (std::string& before = last[id]; before != state) log_event("state " + id + " " + (before = state));
}

// An exercise's toggle, lesson and check, with its verdict. True if it was switched.
bool unfolded_row(const std::string& id, const CheckVerdict* check, float right, Requests& requests) {
    const bool switched = toggle(id);
    ImGui::SameLine(right - width_of("lesson") - width_of("check") - gap);
    if (ImGui::Button("lesson")) requests.lesson = id;
    log_place("lesson." + id);
    help_on_hover("The lesson at this exercise, in the browser");
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("check")) requests.check = id;
    log_place("check." + id);
    help_on_hover("Checks your version beside the window, as ./course check does");
    if (check) check_words(id, *check);
    return switched;
}

// A line for each exercise: its name, in the colour of the version in use, and the verdict. Unfolded also its toggle, its
// lesson, its check and the words of that. True if it was switched.
bool exercise_row(const std::string& id, const CheckVerdict* check, Requests& requests) {
    ImGui::PushID(id.c_str());
    const bool mine = !Exercises::uses_solution(id);
    if (mine) ImGui::PushStyleColor(ImGuiCol_Text, mine_color);
    const bool open = ImGui::TreeNodeEx("exercise", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s", id.c_str());
    if (mine) ImGui::PopStyleColor();
    log_place("exercise." + id);
    const float right = ImGui::GetWindowContentRegionMax().x;
    const bool holds = check && check->of == answer_digest(id);
    const Verdict said = holds ? verdict(*check) : verdict(id);
    const std::string text = holds && check->cases && check->state != CheckVerdict::State::invalid
                                 ? fmt::format("{}: {} of {}", said.name, check->passed, check->cases)
                                 : said.name;
    ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextColored(said.color, "%s", text.c_str());
    log_place("verdict." + id);
    log_state(id, said.name);
    const bool switched = open && unfolded_row(id, check, right, requests);
    ImGui::PopID();
    return switched;
}

}  // namespace

void Panel::exercises(PanelState& state, Requests& requests) {
    const auto rows = [&](const std::vector<std::string>& ids) {
        for (const std::string& id : ids) {
            if (!exercise_row(id, state.checks.find(id), requests)) continue;
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

}  // namespace lightwalk
