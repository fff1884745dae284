// Widgets of the editor's panels, the same with every version of Dear ImGui.
#pragma once
#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "common/image/image.h"
#include "common/window/event_log.h"
#include "common/window/overlay.h"
#include "common/window/panel.h"

namespace lightwalk {

/// A width in pixels beside text of 15 pixels; as many times more beside larger text.
struct TextWidth {
    float px_at_15;
    operator float() const { return px_at_15 * ImGui::GetFontSize() / 15.0f; }
};

/// The column of labels on the left of their fields.
inline constexpr TextWidth label_px{92.0f};

/// Beside a field, at the right end of its row: what resets it, or opens a list of files.
inline float beside_px() { return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x; }

/// A label; the next widget stands beside it.
inline void label_left(const char* label) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    log_place(std::string("label.") + label);
    ImGui::SameLine(left + std::max<float>(label_px, ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x));
}

/// Whether a key went down since the frame before.
inline bool key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(key);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

/// The next widget gets the keyboard where it is wanted. Its window first: Dear ImGui 1.90.1 looks for the widget in
/// the one that has the keyboard now.
inline void focus_next(bool& wanted) {
    if (!std::exchange(wanted, false)) return;
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
}

/// A text field. True if it was changed and left, or Enter was pressed; Escape reverts it. `text` may be another
/// string in each frame, since the edited text is kept here. `hint`: shown while empty.
inline bool text_field(const char* label, std::string& text, const char* hint = "", bool at_once = false,
                       ImGuiInputTextFlags more = 0) {
    static std::map<ImGuiID, std::string> typed;  // where one field is left for another, both are there for a frame
    std::string buffer = text;
    const auto grow = [](ImGuiInputTextCallbackData* data) {
        auto& string = *static_cast<std::string*>(data->UserData);
        string.resize(static_cast<size_t>(data->BufTextLen));
        data->Buf = string.data();
        return 0;
    };
    const ImGuiInputTextFlags flags =
        ImGuiInputTextFlags_CallbackResize | more | (at_once ? 0 : ImGuiInputTextFlags_EnterReturnsTrue);
    const bool enter =
        ImGui::InputTextWithHint(label, hint, buffer.data(), buffer.capacity() + 1, flags, grow, &buffer);
    log_place(std::string("field.") + (label[0] == '#' ? label + 2 : label));
    if (!ImGui::IsItemActive() && ImGui::CalcTextSize(buffer.c_str()).x > ImGui::GetItemRectSize().x)
        help_on_hover(buffer.c_str());
    if (at_once) {
        text = buffer;
        return enter;
    }
    const bool left = !enter && ImGui::IsItemDeactivatedAfterEdit() && !key_pressed(ImGuiKey_Escape);
    const ImGuiID id = ImGui::GetID(label);
    if (ImGui::IsItemActive() || enter) typed[id] = buffer;
    if (enter || left) text = typed[id];
    if (!ImGui::IsItemActive()) typed.erase(id);
    return enter || left;
}

/// Of a list that begins here: brings a row into the middle of its window where it is not in sight.
inline void scroll_to_row(size_t row) {
    const float height = ImGui::GetTextLineHeightWithSpacing();
    const float top = ImGui::GetCursorPosY() + height * static_cast<float>(row);
    const float above = ImGui::GetScrollY(), room = ImGui::GetWindowHeight() - height;
    if (top < above || top > above + room) ImGui::SetScrollY(top - 0.5f * room);
}

/// A small picture at a place of the screen, one rectangle for each run of equal pixels: early versions of Dear ImGui
/// show no images of the renderer's.
inline void draw_pixels(const Image8& picture, ImVec2 at, float pixel) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0, end = 0; x < picture.width; x = end) {
            const glm::u8vec4 c = picture.at(x, y);
            while (end < picture.width && picture.at(end, y) == c) ++end;
            const float top = at.y + static_cast<float>(y) * pixel;
            list.AddRectFilled({at.x + static_cast<float>(x) * pixel, top},
                               {at.x + static_cast<float>(end) * pixel, top + pixel}, IM_COL32(c.r, c.g, c.b, 255));
        }
}

/// A button with a position logged for tests, as "tool." and its name. `text`: what it shows, where that is another.
inline bool tool_button(const char* label, const char* help, bool pressed = false, const std::string& text = "",
                        float width = 0.0f) {
    if (pressed) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0.24f, 0.47f, 0.70f, 1.0f});
    const std::string shown = text.empty() ? label : text;
    const bool clicked = ImGui::Button((shown + "###" + label).c_str(), {width, 0.0f});
    if (pressed) ImGui::PopStyleColor();
    log_place(std::string("tool.") + label);
    help_on_hover(help);
    return clicked;
}

struct ToolButton {
    const char* label;
    std::string text;
    const char* help;
    bool pressed = false;
};

/// Side by side over the whole width; the one that was clicked.
inline std::optional<size_t> tool_row(std::initializer_list<ToolButton> row) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto own = [&](const ToolButton& one) {
        return ImGui::CalcTextSize(one.text.c_str()).x + 2.0f * style.FramePadding.x;
    };
    const auto count = static_cast<float>(row.size());
    float left = ImGui::GetContentRegionAvail().x - (count - 1.0f) * style.ItemSpacing.x;
    for (const ToolButton& one : row) left -= own(one);
    const float more = std::max(left / count, 0.0f);
    std::optional<size_t> clicked;
    size_t index = 0;
    for (const ToolButton& one : row) {
        if (index > 0) ImGui::SameLine();
        if (tool_button(one.label, one.help, one.pressed, one.text, own(one) + more)) clicked = index;
        ++index;
    }
    return clicked;
}

}  // namespace lightwalk
