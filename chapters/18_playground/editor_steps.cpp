// The list of all steps: a click goes back or forward to where one was done.
#include <fmt/core.h>

#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"

namespace lightwalk {

void EditorWindow::draw_steps(float scale) {
    if (!shows_steps_) return void(listed_ = SIZE_MAX);
    ImGui::SetNextWindowPos({covered_px_ + 10.0f * scale, 60.0f * scale}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({260.0f * scale, 320.0f * scale}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("steps", &shows_steps_, ImGuiWindowFlags_NoSavedSettings)) {
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
                const std::string label = row == 0 ? "(before all of these)" : steps[row - 1].name;
                if (ImGui::Selectable(label.c_str(), row == editor.document.done())) done = row;
                if (undone) ImGui::PopStyleColor();
                log_place(fmt::format("step.{}", i));
                ImGui::PopID();
            }
        if (done != editor.document.done()) ++editor.gesture, editor.go_to(*this, done);
    }
    ImGui::End();
}

}  // namespace lightwalk
