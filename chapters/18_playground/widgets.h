// Widgets of the editor's panels, the same with every version of Dear ImGui.
#pragma once
#include <cstring>

#include "common/window/event_log.h"
#include "common/window/overlay.h"
#include "common/window/panel.h"

namespace lightwalk {

/// A field for a text of up to 400 bytes. True where it was changed and left, or Enter was pressed.
inline bool text_field(const char* label, std::string& text, bool at_once = false) {
    char buffer[400];
    const size_t length = std::min(text.size(), sizeof buffer - 1);
    std::memcpy(buffer, text.data(), length);
    buffer[length] = '\0';
    const bool enter =
        ImGui::InputText(label, buffer, sizeof buffer, at_once ? 0 : ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = at_once ? enter : enter || ImGui::IsItemDeactivatedAfterEdit();
    log_place(std::string("field.") + (label[0] == '#' ? label + 2 : label));
    if (at_once || left || ImGui::IsItemActive()) text = buffer;
    return left;
}

/// A button whose place tests know.
inline bool tool_button(const char* label, const char* help, bool pressed = false, ImVec2 size = {0, 0}) {
    if (pressed) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0.24f, 0.47f, 0.70f, 1.0f});
    const bool clicked = ImGui::Button(label, size);
    if (pressed) ImGui::PopStyleColor();
    log_place(std::string("tool.") + label);
    help_on_hover(help);
    return clicked;
}

}  // namespace lightwalk
