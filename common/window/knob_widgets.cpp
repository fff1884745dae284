#include "common/window/knob_widgets.h"

#include <imgui.h>

#include <cmath>
#include <nlohmann/json.hpp>

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

bool widget(Knob<float>& knob, const char* id) {
    const auto [lower, upper] = knob.range;
    const bool tiny = lower > 0.0f && lower < 1e-3f;
    const char* const format = tiny ? "%.6f" : number_format(upper - lower);
    return ImGui::SliderFloat(id, &knob.value, lower, upper, with_unit(format, knob.unit).c_str(),
                              slider_flags(lower, upper));
}

bool widget(Knob<int>& knob, const char* id) {
    const auto [lower, upper] = knob.range;
    return ImGui::SliderInt(id, &knob.value, lower, upper, with_unit("%d", knob.unit).c_str(),
                            slider_flags(static_cast<float>(lower), static_cast<float>(upper)));
}

// Three numbers from 0 to 1 without a unit are a colour.
bool widget(Knob<glm::vec3>& knob, const char* id) {
    const float lower = knob.range.lower.x, upper = knob.range.upper.x;
    if (knob.unit.empty() && lower == 0.0f && upper == 1.0f)
        return ImGui::ColorEdit3(id, &knob.value.x, ImGuiColorEditFlags_Float);
    return ImGui::SliderFloat3(id, &knob.value.x, lower, upper,
                               with_unit(number_format(upper - lower), knob.unit).c_str(),
                               ImGuiSliderFlags_AlwaysClamp);
}

bool widget(Knob<bool>& knob, const char* id) { return ImGui::Checkbox(id, &knob.value); }

bool widget(Choice& knob, const char* id) {
    bool changed = false;
    if (!ImGui::BeginCombo(id, knob.text().c_str())) return false;
    for (size_t i = 0; i < knob.options.size(); ++i) {
        if (ImGui::Selectable(knob.options[i].c_str(), i == knob.index)) {
            changed = i != knob.index;
            knob.index = i;
        }
        log_place("option." + knob.name + "." + knob.options[i]);
    }
    ImGui::EndCombo();
    return changed;
}

bool widget(KnobBase& knob, const char* id) {
    if (auto* number = dynamic_cast<Knob<float>*>(&knob)) return widget(*number, id);
    if (auto* whole = dynamic_cast<Knob<int>*>(&knob)) return widget(*whole, id);
    if (auto* vector = dynamic_cast<Knob<glm::vec3>*>(&knob)) return widget(*vector, id);
    if (auto* on_off = dynamic_cast<Knob<bool>*>(&knob)) return widget(*on_off, id);
    if (auto* choice = dynamic_cast<Choice*>(&knob)) return widget(*choice, id);
    ImGui::TextUnformatted(knob.text().c_str());
    return false;
}

void tooltip(const KnobBase& knob) {
    const nlohmann::json described = knob.describe();
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(knob.help.c_str());
    std::string facts;
    if (described.contains("range"))
        facts = described["range"][0].dump() + " to " + described["range"][1].dump() + " " + knob.unit + "; ";
    const auto& initial = described["default"];
    facts += "default " + (initial.is_string() ? initial.get<std::string>() : initial.dump()) + " (right click)";
    ImGui::TextColored(quiet_color, "%s", facts.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

bool knob_widget(KnobBase& knob, const std::string& beside) {
    const float label_width = ImGui::GetFontSize() * 6.6f;
    std::string label = knob.name;
    for (char& c : label)
        if (c == '_') c = ' ';
    ImGui::PushID(&knob);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    bool hovered = ImGui::IsItemHovered();
    ImGui::SameLine(label_width);
    const float room = ImGui::CalcTextSize(beside.c_str()).x;
    ImGui::SetNextItemWidth(beside.empty() ? -1.0f : -room - ImGui::GetStyle().ItemSpacing.x);
    bool changed = widget(knob, "##value");
    log_place("knob." + knob.name);
    hovered = hovered || ImGui::IsItemHovered();
    if (!beside.empty()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - room);
        ImGui::TextColored(quiet_color, "%s", beside.c_str());
    }
    if (hovered && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) tooltip(knob);
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        const std::string before = knob.text();
        knob.reset();
        changed = changed || knob.text() != before;
    }
    ImGui::PopID();
    return changed;
}

}  // namespace lightwalk
