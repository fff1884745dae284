#include "common/window/knob_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <climits>
#include <cmath>

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

std::string with_unit(const char* format, const std::string& unit) {
    std::string result = format;
    for (const char c : unit.empty() ? std::string() : " " + unit)
        result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

// Where a range spans decades, a step at its lower end matters as much as one at the upper.
ImGuiSliderFlags slider_flags(float lower, float upper) {
    const bool decades = lower >= 0.0f && upper >= 1000.0f * (lower > 0.0f ? lower : 1.0f);
    return ImGuiSliderFlags_AlwaysClamp | (decades ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

// As many decimals as a thousandth of the range needs.
const char* number_format(float span) {
    return span >= 1000.0f ? "%.0f" : span >= 100.0f ? "%.1f" : span >= 10.0f ? "%.2f" : "%.3f";
}

// Some widgets accept typed values outside their range, and none rejects non-numbers: 0 times 1e39.
void keep_in_range(float& value, float before, float lower, float upper) {
    if (value != before) value = std::isnan(value) ? before : std::clamp(value, lower, upper);
}

bool widget(Knob<float>& knob, const char* id) {
    const auto [lower, upper] = knob.range;
    const float before = knob.value;
    const bool tiny = lower > 0.0f && lower < 1e-3f;
    const char* const format = tiny ? "%.6f" : number_format(upper - lower);
    const bool changed = ImGui::SliderFloat(id, &knob.value, lower, upper, with_unit(format, knob.unit).c_str(),
                                            slider_flags(lower, upper));
    keep_in_range(knob.value, before, lower, upper);
    return changed;
}

bool widget(Knob<int>& knob, const char* id) {
    constexpr int most = INT_MAX / 2;  // ImGui ends the program at a slider for more
    const int lower = std::max(knob.range.lower, -most), upper = std::min(knob.range.upper, most);
    return ImGui::SliderInt(id, &knob.value, lower, upper, with_unit("%d", knob.unit).c_str(),
                            slider_flags(static_cast<float>(lower), static_cast<float>(upper)));
}

// Three numbers from 0 to 1 without a unit are a colour.
bool widget(Knob<glm::vec3>& knob, const char* id) {
    const float lower = knob.range.lower.x, upper = knob.range.upper.x;
    const glm::vec3 before = knob.value;
    const bool is_color = knob.unit.empty() && lower == 0.0f && upper == 1.0f;
    const std::string format = with_unit(number_format(upper - lower), knob.unit);
    const bool changed =
        is_color ? ImGui::ColorEdit3(id, &knob.value.x, ImGuiColorEditFlags_Float)
                 : ImGui::SliderFloat3(id, &knob.value.x, lower, upper, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    for (int i = 0; i < 3; ++i) keep_in_range(knob.value[i], before[i], lower, upper);
    return changed;
}

void wrapped_tooltip(const std::string& text, const std::string& facts = "") {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.c_str());
    if (!facts.empty()) ImGui::TextColored(quiet_color, "%s", facts.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool widget(Knob<bool>& knob, const char* id) { return ImGui::Checkbox(id, &knob.value); }

// The last entry of a menu of methods: asks for the need rule, which then chooses as --method auto does.
void auto_entry(const std::string& path, AutoChoices& automatic) {
    ImGui::Separator();
    if (ImGui::Selectable("auto", false)) automatic.wanted = path;
    log_place("option." + path + ".auto");
    if (ImGui::IsItemHovered())
        wrapped_tooltip(
            "Measures all methods in this picture, once, and takes the fastest one whose error is within the budget.");
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderFloat("##budget", &automatic.budget, 0.0f, 0.2f, "budget: FLIP %.3f", ImGuiSliderFlags_AlwaysClamp);
    log_place("budget." + path);
    if (ImGui::IsItemHovered()) wrapped_tooltip("Error budget of auto: greatest mean FLIP against the reference.");
}

bool widget(Choice& knob, const char* id, AutoChoices* automatic) {
    bool changed = false;
    const std::string path = knob.path();
    const bool by_auto = automatic && automatic->holds(path, knob.text());
    // All of it in sight: of more than eight options, those behind and "auto" would have to be scrolled for.
    if (!ImGui::BeginCombo(id, (knob.text() + (by_auto ? " (auto)" : "")).c_str(), ImGuiComboFlags_HeightLargest))
        return false;
    for (size_t i = 0; i < knob.options.size(); ++i) {
        if (ImGui::Selectable(knob.options[i].c_str(), i == knob.index)) {
            changed = i != knob.index;
            knob.index = i;
            if (automatic) automatic->chosen.erase(path);  // this was a person's choice
        }
        if (const std::string words = option_help(knob.help, knob.options[i]); !words.empty() && ImGui::IsItemHovered())
            wrapped_tooltip(words);
        log_place("option." + path + "." + knob.options[i]);
    }
    if (automatic && automatic->offered.contains(path)) auto_entry(path, *automatic);
    if (automatic && automatic->without.contains(path)) {
        ImGui::Separator();
        ImGui::TextColored(quiet_color, "no auto: no study compares these");
        log_place("no auto." + path);
    }
    ImGui::EndCombo();
    return changed;
}

bool widget(KnobBase& knob, const char* id, AutoChoices* automatic) {
    if (auto* number = dynamic_cast<Knob<float>*>(&knob)) return widget(*number, id);
    if (auto* whole = dynamic_cast<Knob<int>*>(&knob)) return widget(*whole, id);
    if (auto* vector = dynamic_cast<Knob<glm::vec3>*>(&knob)) return widget(*vector, id);
    if (auto* on_off = dynamic_cast<Knob<bool>*>(&knob)) return widget(*on_off, id);
    if (auto* choice = dynamic_cast<Choice*>(&knob)) return widget(*choice, id, automatic);
    ImGui::TextUnformatted(knob.text().c_str());
    return false;
}

// The name in words. The unit, which some names end with, stands in the widget.
std::string label_of(const KnobBase& knob) {
    std::string label = knob.name, suffix = "_" + (knob.unit == "degrees" || knob.unit == "°" ? "deg" : knob.unit);
    std::replace(suffix.begin(), suffix.end(), '/', '_');
    if (!knob.unit.empty() && label.size() > suffix.size() &&
        label.compare(label.size() - suffix.size(), suffix.size(), suffix) == 0)
        label.resize(label.size() - suffix.size());
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

}  // namespace

// Drawn, because not every font has one.
bool reset_button(const std::string& place) {
    const float side = ImGui::GetFrameHeight();
    const bool clicked = ImGui::InvisibleButton("##reset", {side, side});
    log_place("reset." + place);
    const ImVec2 from = ImGui::GetItemRectMin(), middle{from.x + 0.5f * side, from.y + 0.5f * side};
    const ImU32 color =
        ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : mine_color);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = 0.24f * side;
    list.PathArcTo(middle, radius, -2.2f, 2.6f, 16);
    list.PathStroke(color, 0, 0.07f * side);
    const ImVec2 tip{middle.x + radius * std::cos(-2.2f), middle.y + radius * std::sin(-2.2f)};
    const float wing = 0.17f * side;
    list.AddTriangleFilled({tip.x - wing, tip.y + 0.3f * wing}, {tip.x + 0.7f * wing, tip.y - wing},
                           {tip.x + 0.7f * wing, tip.y + wing}, color);
    if (ImGui::IsItemHovered()) wrapped_tooltip("Sets the default again.");
    return clicked;
}

std::string option_help(const std::string& help, const std::string& option) {
    const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    const auto names = [&](std::string_view part) {
        for (size_t at = part.find(option); at != part.npos; at = part.find(option, at + 1)) {
            const size_t end = at + option.size();
            if ((at == 0 || !in_word(part[at - 1])) && (end == part.size() || !in_word(part[end]))) return true;
        }
        return false;
    };
    size_t begin = help.find(": ");
    begin = begin == help.npos ? 0 : begin + 2;
    int depth = 0;
    for (size_t at = begin; at <= help.size(); ++at) {
        const char c = at < help.size() ? help[at] : ';';
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth > 0 || (c != ',' && c != ';')) continue;
        std::string_view part = std::string_view(help).substr(begin, at - begin);
        begin = at + 1;
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        for (const std::string_view joint : {"or ", "and "})
            if (part.substr(0, joint.size()) == joint) part.remove_prefix(joint.size());
        if (names(part) && part.size() > option.size()) return std::string(part);
    }
    return {};
}

float label_column(const KnobList& knobs) {
    const float gap = ImGui::GetStyle().ItemSpacing.x, most = 0.5f * ImGui::GetContentRegionAvail().x;
    float widest = 0;
    for (const KnobBase* knob : knobs)
        if (const float width = ImGui::CalcTextSize(label_of(*knob).c_str()).x + gap; width <= most)
            widest = std::max(widest, width);
    return widest;
}

bool knob_widget(KnobBase& knob, float label_width, const std::string& beside, AutoChoices* automatic) {
    ImGui::PushID(&knob);
    const float left = ImGui::GetCursorPosX(), gap = ImGui::GetStyle().ItemSpacing.x;
    const std::string label = label_of(knob);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(knob.changed() ? mine_color : ImGui::GetStyleColorVec4(ImGuiCol_Text), "%s", label.c_str());
    log_place("label." + knob.path());
    bool hovered = ImGui::IsItemHovered();
    if (dynamic_cast<Knob<glm::vec3>*>(&knob))  // three numbers have a line of their own
        ImGui::SetCursorPosX(left);
    else if (ImGui::CalcTextSize(label.c_str()).x + gap <= label_width)
        ImGui::SameLine(left + label_width);
    else
        ImGui::SetCursorPosX(left + label_width);
    const float cost = beside.empty() ? 0.0f : ImGui::CalcTextSize(beside.c_str()).x + gap;
    // All end in one line, with a button to reset or without.
    const float right = cost + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(-right);
    bool changed = widget(knob, "##value", automatic);
    log_place("knob." + knob.path(), dynamic_cast<Choice*>(&knob) ? knob.text() : "");
    hovered = hovered || ImGui::IsItemHovered();
    if (knob.changed()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - right);
        if (reset_button(knob.path())) {
            knob.reset();
            changed = true;
        }
    }
    if (!beside.empty()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - cost + gap);
        ImGui::TextColored(quiet_color, "%s", beside.c_str());
    }
    if (hovered && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        const bool by_auto = automatic && automatic->holds(knob.path(), knob.text());
        wrapped_tooltip(knob.help, knob.usage() + (by_auto ? "\nauto: " + automatic->chosen[knob.path()].line : ""));
    }
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        const std::string before = knob.text();
        knob.reset();
        changed = changed || knob.text() != before;
    }
    ImGui::PopID();
    return changed;
}

}  // namespace lightwalk
