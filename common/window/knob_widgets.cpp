#include "common/window/knob_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <climits>
#include <cmath>
#include <cstdio>
#include <functional>

#include "common/app/module.h"
#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

bool is_angle(const std::string& unit) { return unit == "degrees" || unit == "°"; }

std::string after_number(const std::string& unit) { return unit.empty() ? "" : is_angle(unit) ? "°" : " " + unit; }

std::string with_unit(const char* format, const std::string& unit) {
    std::string result = format;
    for (const char c : after_number(unit)) result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

// Where a range spans decades from its end or its default on, a step at its lower end matters as much as one at the upper.
bool spans_decades(float lower, float upper, float usual) {
    const float least = lower > 0.0f ? lower : usual > 0.0f ? std::min(usual, 1.0f) : 1.0f;
    return lower >= 0.0f && upper >= 1000.0f * least;
}

ImGuiSliderFlags slider_flags(bool decades) {
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

// A slider with its number beside it, which the grab would hide, and its unit where there is room. True: it was changed.
bool slider_beside_number(const char* id, const std::function<bool()>& slider,
                          const std::function<std::string(bool)>& text) {
    const float whole = ImGui::CalcItemWidth(), width = std::floor(0.58f * whole), beside = whole - width;
    const bool is_typed = number_typed_into() == ImGui::GetID(id);
    ImGui::BeginGroup();
    ImGui::SetNextItemWidth(width);
    if (!is_typed) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{});
    const bool changed = slider();
    if (!is_typed) ImGui::PopStyleColor();
    ImGui::SameLine(0.0f, 0.0f);
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({beside, ImGui::GetFrameHeight()});
    std::string number = text(true);
    if (ImGui::CalcTextSize(number.c_str()).x > beside - style.ItemInnerSpacing.x) number = text(false);
    ImGui::GetWindowDrawList()->AddText({corner.x + style.ItemInnerSpacing.x, corner.y + style.FramePadding.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), number.c_str());
    ImGui::EndGroup();
    return changed;
}

bool widget(Knob<float>& knob, const char* id) {
    const float lower = knob.range.lower, upper = knob.range.upper;  // no binding: clang 14 lets no lambda capture one
    const float before = knob.value;
    const bool tiny = lower > 0.0f && lower < 1e-3f, decades = spans_decades(lower, upper, knob.default_value);
    const char* const format = tiny ? "%.6f" : decades ? "%.5g" : number_format(upper - lower);
    const char* const shown = tiny || !decades ? format : before < 1000.0f ? "%.3g" : "%.0f";
    const bool changed = slider_beside_number(
        id, [&] { return ImGui::SliderFloat(id, &knob.value, lower, upper, format, slider_flags(decades)); },
        [&](bool unit) {
            char number[64];
            std::snprintf(number, sizeof number, shown, double(knob.value));
            return number + (unit ? after_number(knob.unit) : "");
        });
    keep_in_range(knob.value, before, lower, upper);
    return changed;
}

bool widget(Knob<int>& knob, const char* id) {
    constexpr int most = INT_MAX / 2;  // ImGui ends the program at a slider for more
    const int lower = std::max(knob.range.lower, -most), upper = std::min(knob.range.upper, most);
    const bool decades = spans_decades(float(lower), float(upper), 1.0f);
    return slider_beside_number(
        id, [&] { return ImGui::SliderInt(id, &knob.value, lower, upper, "%d", slider_flags(decades)); },
        [&](bool unit) { return knob.text() + (unit ? after_number(knob.unit) : ""); });
}

// Three numbers from 0 to 1 without a unit are a colour.
bool widget(Knob<glm::vec3>& knob, const char* id) {
    const float lower = knob.range.lower.x, upper = knob.range.upper.x;
    const glm::vec3 before = knob.value;
    const bool is_color = knob.unit.empty() && lower == 0.0f && upper == 1.0f;
    const glm::vec3 size = glm::abs(before);
    const float speed = std::min(0.002f * (upper - lower), 0.01f * std::max({1.0f, size.x, size.y, size.z}));
    const std::string format = with_unit("%.4g", knob.unit);
    const bool changed = is_color ? ImGui::ColorEdit3(id, &knob.value.x, ImGuiColorEditFlags_Float)
                                  : ImGui::DragFloat3(id, &knob.value.x, speed, lower, upper, format.c_str(),
                                                      ImGuiSliderFlags_AlwaysClamp);
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

// The knob's name up to its unit, which stands in the widget.
std::string_view name_without_unit(const KnobBase& knob) {
    const std::string_view name = knob.name;
    for (const char* const per : {"_", "_per_"}) {
        std::string suffix = "_" + (is_angle(knob.unit) ? "deg" : knob.unit);
        if (const size_t slash = suffix.find('/'); slash != suffix.npos) suffix.replace(slash, 1, per);
        if (!knob.unit.empty() && name.size() > suffix.size() && name.ends_with(suffix))
            return name.substr(0, name.size() - suffix.size());
    }
    return name;
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

std::string label_of(const KnobBase& knob) {
    const std::string_view name = name_without_unit(knob);
    std::string label(name);
    std::replace(label.begin(), label.end(), '_', ' ');
    if (name == knob.name) return label;
    const KnobList all = knob.owner.all_knobs();
    const bool is_alone = std::none_of(all.begin(), all.end(), [&](const KnobBase* other) {
        return other != &knob && &other->owner == &knob.owner && name_without_unit(*other) == name;
    });
    return is_alone ? label : label + " (" + knob.unit + ")";
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
    log_place("knob." + knob.path());
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
