// The editor's panels: where each of them stands.
#include <algorithm>

#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"

namespace lightwalk {

// Not in a window in which it would cover most of the picture, as the panel on the right.
float EditorWindow::covered_px(glm::uvec2 picture, float scale) const {
    const float wanted = 270.0f * scale;
    return wanted < 0.6f * static_cast<float>(picture.x) ? wanted : 0.0f;
}

bool EditorWindow::draw_panels(glm::uvec2 picture, float scale) {
    view_.picture = picture;
    view_.covered_px = covered_px(picture, scale);
    view_.automatic = automatic;
    const bool changed = std::exchange(view_.changed, false);
    const uint64_t state = editor.document.state();
    const std::vector<EntryId> selected = editor.selection.ids;
    const auto handles = std::pair(editor.tool, editor.local);
    if (view_.covered_px > 0.0f) {
        draw_left_panel();
    } else {
        tree_.give_up_fields();
        properties_.wants_keyboard = false;
    }
    browser_.draw(scale, view_.covered_px);
    loading_.draw(scale);
    steps_.draw(scale);
    keys_.draw(scale);
    files_.draw_question();
    carry_on_previews();
    return changed || state != editor.document.state() || selected != editor.selection.ids ||
           handles != std::pair(editor.tool, editor.local) || editor.document.in_step();
}

void EditorWindow::draw_left_panel() {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({view_.covered_px, static_cast<float>(view_.picture.y)});
    ImGui::SetNextWindowBgAlpha(0.88f);
    ImGui::Begin("editor", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_toolbar();
    draw_lights_toolbar();
    tree_.draw();
    properties_.draw();
    ImGui::End();
}

void EditorWindow::draw_toolbar() {
    if (tool_button("open", "Ctrl+O: files, to add or to open")) browser_.shown = !browser_.shown;
    ImGui::SameLine();
    if (tool_button("undo", "Ctrl+Z")) editor.undo(*this);
    ImGui::SameLine();
    if (tool_button("redo", "Ctrl+Y")) editor.redo(*this);
    ImGui::SameLine();
    if (tool_button("steps", "F4: all steps by name; a click goes back or forward to one", steps_.shown))
        steps_.shown = !steps_.shown;
    ImGui::SameLine();
    if (tool_button("?", "F1: all keys", keys_.shown)) keys_.shown = !keys_.shown;
    if (tool_button("move", "1: move along axes and planes; with Shift in steps", editor.tool == Tool::move))
        editor.tool = Tool::move;
    ImGui::SameLine();
    if (tool_button("turn", "2: rotate; with Shift by 15°", editor.tool == Tool::rotate)) editor.tool = Tool::rotate;
    ImGui::SameLine();
    if (tool_button("size", "3: scale", editor.tool == Tool::scale)) editor.tool = Tool::scale;
    ImGui::SameLine();
    if (tool_button(editor.local ? "local" : "world", "L: axes of the world or of the object"))
        editor.local = !editor.local;
}

void EditorWindow::draw_lights_toolbar() {
    const char* const kinds[] = {"sun", "lamp", "spot"};
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine();
        if (tool_button(kinds[i], "Add a light: directional, point, spot"))
            editor.add_light(*this, static_cast<Light::Kind>(i));
    }
    if (tool_button("scatter", "Point and spot lights over the scene, as many as the number says")) scatter_lights();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::DragInt("##scatter", &scatter_count_, 10.0f, 1, 100000, "%d lights");
    scatter_count_ = std::clamp(scatter_count_, 1, 100000);
    log_place("number.scatter");
    help_on_hover("Number of lights that are scattered, up to 100,000");
}

void EditorWindow::scatter_lights() {
    editor.selection.set(scatter(editor.document, scene.bounds, scatter_count_, unsigned(editor.document.size())));
}

void EditorWindow::carry_on_previews() {
    if (!view_.gpu) return;
    try {
        if (properties_.ball.is_due())
            properties_.ball.make();
        else if (browser_.shown && browser_.thumbnails.carry_on(*view_.gpu, properties_.ball.preview))
            view_.changed = true;
    } catch (const InputError& e) { editor.notice = e.what(); }
}

}  // namespace lightwalk
