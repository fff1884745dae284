#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "18_playground/editor_part.h"
#include "18_playground/properties.h"
#include "18_playground/widgets.h"

namespace lightwalk {
namespace {

constexpr const char* dash = "—";  // for a number that is not the same in all

// Over the last drawn field, which itself has all digits: a person edits the full value, since Dear ImGui would round
// a dragged one to the text.
void draw_short(float value) {
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    const float room = upper.x - lower.x - 4.0f;  // a sign and a point are narrower than a digit
    const auto fits = [&](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x <= room; };
    const std::string text = short_number(value, fits);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{0.5f * (lower.x + upper.x - size.x), 0.5f * (lower.y + upper.y - size.y)};
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

}  // namespace

void EditorFields::begin_frame() {
    if (!ImGui::IsAnyItemActive()) {
        refused_.clear();
        stops_drag_ = false;
    }
    drags_ = false;
}

void EditorFields::take_drag_back() {
    editor.document.take_back(editor.gesture);
    stops_drag_ = true;
    drags_ = false;
}

// Dear ImGui applies each typed digit. Here a typed value counts once, when its field is left by Enter, Tab or a
// click; Escape reverts it, and a refused value leaves no trace. Dragging counts at once. `has_list`: whether fields
// of a list opened by the widget are its own, too.
bool EditorFields::once_left(uint32_t field, float* values, int count, const std::function<bool()>& widget,
                             const std::function<bool()>& has_list) {
    const auto copy = [&](const float* from, float* to) { std::copy(from, from + count, to); };
    glm::vec3 before(0.0f);
    copy(values, &before.x);
    const auto typed = typed_.find(field);
    const int frame = ImGui::GetFrameCount();
    const bool was_typed = typed != typed_.end() && typed->second.frame >= frame - 1;
    if (was_typed) copy(&typed->second.values.x, values);
    const bool changed = widget();
    if (ImGui::IsItemActive() && number_typed_into() == 0) {
        if (std::exchange(stops_drag_, false)) {
            stop_dragging();
            copy(&before.x, values);
            return false;
        }
        drags_ = true;
    }
    const uint32_t into = number_typed_into(), item = into == field || has_list() ? into : 0;
    if (item && (!was_typed || item == typed->second.item)) {
        if (changed || was_typed) copy(values, &(typed_[field] = {item, frame}).values.x);
        copy(&before.x, values);
        return false;
    }
    if (typed != typed_.end()) typed_.erase(typed);
    if (!was_typed) return changed;
    if (key_pressed(ImGuiKey_Escape)) copy(&before.x, values);
    ++editor.gesture;
    refused_.clear();
    return !std::equal(values, values + count, &before.x);
}

// Side by side, up to `right` pixels before the edge.
bool EditorFields::three_numbers(glm::vec3& value, float right, float speed, float lower, float upper,
                                 glm::bvec3 mixed) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, width = ImGui::GetContentRegionAvail().x - right;
    const float each = std::max(std::floor((width - 2.0f * gap) / 3.0f), 1.0f);
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        if (i) ImGui::SameLine(0.0f, gap);
        ImGui::PushID(i);
        const ImGuiID field = ImGui::GetID("##number");
        changed |= once_left(field, &value[i], 1, [&] {
            ImGui::SetNextItemWidth(i < 2 ? each : std::max(width - 2.0f * (each + gap), 1.0f));
            const bool is_short = !mixed[i] && number_typed_into() != field;
            if (is_short) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{});
            const std::string all = exact_format(value[i]);
            const bool edited = ImGui::DragFloat("##number", &value[i], speed, lower, upper,
                                                 mixed[i] ? dash : all.c_str(), ImGuiSliderFlags_NoRoundToFormat);
            if (is_short) ImGui::PopStyleColor();
            if (is_short && number_typed_into() != field) draw_short(value[i]);
            return edited;
        });
        ImGui::PopID();
    }
    return changed;
}

// A typed value has no range of its own: 1e39 is infinite, and 0 times that is not a number.
bool EditorFields::takes(const char* label, float* values, int count, const float* before, float lower, float upper) {
    for (int i = 0; i < count; ++i)
        if (!(values[i] >= lower && values[i] <= upper)) {
            refuse(fmt::format("{}: {:g} is out of range, {:g} to {:g}", label, values[i], lower, upper));
            std::copy(before, before + count, values);
            return false;
        }
    return true;
}

bool EditorFields::numbers(const char* label, const char* help, glm::vec3& value, float speed, glm::bvec3 mixed) {
    const glm::vec3 before = value;
    label_left(label);
    ImGui::BeginGroup();
    ImGui::PushID(label);
    const bool changed = three_numbers(value, beside_px(), speed, 0.0f, 0.0f, mixed);
    ImGui::PopID();
    ImGui::EndGroup();
    log_place(std::string("numbers.") + label);
    help_on_hover(help);
    return changed && takes(label, &value.x, 3, &before.x, -1e9f, 1e9f);
}

bool EditorFields::number(const char* label, const char* help, float& value, float speed, float lower, float upper,
                          bool mixed, const char* most) {
    const float before = value;
    label_left(label);
    const std::string field = std::string("##") + label;
    const char* const format = mixed ? dash : value >= upper ? most : "%.5g";
    const bool changed = once_left(ImGui::GetID(field.c_str()), &value, 1, [&] {
        ImGui::SetNextItemWidth(-beside_px());
        return ImGui::DragFloat(field.c_str(), &value, speed, lower, upper, format);
    });
    log_place(std::string("number.") + label);
    help_on_hover(help);
    return changed && takes(label, &value, 1, &before, lower, upper);
}

// Dear ImGui writes three decimals of each, which are cut here.
bool EditorFields::color(const char* label, const char* help, glm::vec3& value, float most, glm::bvec3 mixed) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const glm::vec3 before = value;
    label_left(label);
    ImGui::PushID(label);
    ImGui::BeginGroup();
    bool changed = three_numbers(value, beside_px() + ImGui::GetFrameHeight() + gap, 0.01f, 0.0f, most, mixed);
    ImGui::EndGroup();
    log_place(std::string("color.") + label);
    help_on_hover(help);
    ImGui::SameLine(0.0f, gap);
    changed |= once_left(
        ImGui::GetID("##color"), &value.x, 3,
        [&] {
            return ImGui::ColorEdit3(
                "##color", &value.x,
                ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel);
        },
        [&] {
            ImGui::PushID("##color");
            const bool open = ImGui::IsPopupOpen("picker");
            ImGui::PopID();
            return open;
        });
    ImGui::PopID();
    return changed && takes(label, &value.x, 3, &before.x, 0.0f, most);
}

bool EditorFields::check(const char* label, const char* help, bool& on, bool mixed) {
    int bits = mixed ? 1 : on ? 3 : 0;  // of two: one of them alone is drawn as neither on nor off
    const bool changed = ImGui::CheckboxFlags(label, &bits, 3);
    log_place(std::string("check.") + label);
    help_on_hover(help);
    on = bits == 3;
    return changed;
}

bool EditorFields::choice(const char* label, std::initializer_list<const char*> names, float& index, bool mixed) {
    label_left(label);
    ImGui::SetNextItemWidth(-beside_px());
    const bool open = ImGui::BeginCombo((std::string("##") + label).c_str(),
                                        mixed ? dash : names.begin()[static_cast<size_t>(index)]);
    log_place(std::string("choice.") + label);
    if (!open) return false;
    bool changed = false;
    float i = 0.0f;
    for (const char* option : names) {
        if (ImGui::Selectable(option, !mixed && i == index)) {
            index = i;
            changed = true;
        }
        log_place(std::string("option.") + option);
        ++i;
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace lightwalk
