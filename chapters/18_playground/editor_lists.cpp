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

void KeysPanel::draw() {
    static constexpr const char* keys[][2] = {{"click", "select; with Shift: add to the selection"},
                                              {"drag a handle", "move, rotate, scale; with Shift in steps"},
                                              {"1, 2, 3, L", "move, rotate, scale; world or local axes"},
                                              {"F, Home", "frame what is selected; the scene's own view"},
                                              {"Up, Down", "the tree: select another entry"},
                                              {"Left, Right", "the tree: fold, unfold"},
                                              {"Enter, Tab", "type numbers of what is selected; the next one"},
                                              {"Ctrl+F, R", "search the tree; rename, as by a double click"},
                                              {"Shift+H, L", "hide or show; lock or unlock"},
                                              {"Shift+1 to 4", "add a sun, a lamp, a spot; scatter lights"},
                                              {"Ctrl+Z, Y, F4", "undo, redo; the list of all steps"},
                                              {"Ctrl+D, G, Del", "duplicate, group, delete"},
                                              {"Ctrl+O, S, E", "files, save (with Shift: as), export to glTF"},
                                              {"Ctrl+A, Esc", "select all; nothing, then (twice) close"},
                                              {"F12, F6, F1", "picture; passes as a graph; these keys"},
                                              {"F2, F3, F5, H", "all exercises, split view, reload, knobs"},
                                              {"drag, wheel", "orbit, come closer"},
                                              {"right button", "look and fly; in the tree: an entry's menu"}};
    if (tool_button("tour", "Ten steps that show the editor; it can be left at any time", false, "take the tour",
                    -1.0f)) {
        shown = false;
        tour_();
    }
    ImGui::BeginChild("keys", {0.0f, 0.0f});
    ImGui::BeginTable("keys", 2);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, TextWidth{104.0f});
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [key, help] : keys) {
        ImGui::TableNextColumn();
        ImGui::TextColored(reference_color, "%s", key);
        log_place(std::string("key.") + key);
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", help);
    }
    ImGui::EndTable();
    ImGui::EndChild();
}

}  // namespace lightwalk
