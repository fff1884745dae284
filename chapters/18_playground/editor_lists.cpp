#include "18_playground/editor_lists.h"

#include <fmt/core.h>

#include "18_playground/widgets.h"

namespace lightwalk {

void StepsPanel::draw() {
    ImGui::BeginChild("steps", {0.0f, 0.0f});
    const std::vector<Document::Listed> steps = editor.document.steps();
    size_t done = editor.document.done();
    if (std::exchange(listed_, done) != done) scroll_to_row(done);
    // Row i is where i steps are done.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(steps.size()) + 1);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto row = static_cast<size_t>(i);
            const bool undone = row > 0 && steps[row - 1].undone;
            ImGui::PushID(i);
            if (undone) ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
            const std::string label = row == 0 ? "as it was opened" : steps[row - 1].name;
            if (ImGui::Selectable(label.c_str(), row == editor.document.done())) done = row;
            if (undone) ImGui::PopStyleColor();
            log_place(fmt::format("step.{}", i));
            ImGui::PopID();
        }
    if (steps.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        ImGui::TextWrapped("Each change adds a step below. A click on a step goes back or forward to it.");
        ImGui::PopStyleColor();
    }
    if (done != editor.document.done()) {
        ++editor.gesture;
        editor.go_to(view_.chapter, done);
    }
    ImGui::EndChild();
}

void KeysPanel::draw(float scale) {
    if (!shown) return;
    const ImVec2 corner{static_cast<float>(view_.picture.corner.x) + 10.0f * scale, 10.0f * scale};
    ImGui::SetNextWindowPos(corner, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("keys", &shown, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize)) {
        static constexpr const char* keys[][2] = {
            {"click, Shift and click", "select; add to the selection"},
            {"drag a handle", "move, rotate, scale; with Shift in steps"},
            {"1, 2, 3, L", "move, rotate, scale; world or local axes"},
            {"F", "frame what is selected"},
            {"Up, Down, Left, Right", "the tree: select another entry; fold, unfold"},
            {"Enter, Tab", "type numbers of what is selected; the next one"},
            {"properties of several", "what is typed is set in all; a dash: they differ"},
            {"Ctrl+F, Ctrl+R", "search the tree; rename, as by a double click"},
            {"Shift+H, Shift+L", "hide or show; lock or unlock"},
            {"Shift+1, 2, 3, 4", "add a sun, a lamp, a spot; scatter lights"},
            {"Ctrl+Z, Ctrl+Y, F4", "undo, redo; the list of all steps"},
            {"Ctrl+D, Ctrl+G, Del", "duplicate, group, delete"},
            {"Ctrl+O, Ctrl+S, Ctrl+E", "files, save (with Shift: as), export to glTF"},
            {"Ctrl+A, Esc", "select all; nothing, then (twice) close"},
            {"F12, F6, F1, H", "picture; passes as a graph; these keys; the knobs"},
            {"F2, F3, F5", "switch all exercises, mine beside reference, reload"},
            {"drag, wheel, right button", "orbit, come closer, look and fly"},
            {"right button in the tree", "what can be done with an entry"}};
        for (const auto& [key, help] : keys) {
            ImGui::TextColored(reference_color, "%-28s", key);
            ImGui::SameLine(220.0f * scale);
            ImGui::TextUnformatted(help);
        }
        if (tool_button("tour", "Ten steps that show the editor; it can be left at any time")) {
            shown = false;
            tour_();
        }
    }
    ImGui::End();
}

}  // namespace lightwalk
