#include "18_playground/editor_window.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/camera_control.h"
#include "common/window/event_log.h"

namespace lightwalk {

EditorWindow::EditorWindow() {
    browser_.chosen = [this](const std::filesystem::path& file, bool adds) { choose_file(file, adds); };
    view_.pick = [this](const std::string& what, const FileBrowser::Take& take) {
        show_list(browser_.shown, true);
        browser_.pick_image(what, take);
    };
    view_.press = [this](const KeyPress& key) {
        if (key.mods & GLFW_MOD_CONTROL)
            on_control_key(key);
        else if (key.mods & GLFW_MOD_SHIFT)
            on_shift_key(key.key);
        else
            on_key(key);
    };
}

bool EditorWindow::on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) {
    leaving_ = leaving_ && !input.left;
    return pointer_.move(input, cursor_px, over_picture);
}

void EditorWindow::on_drop(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) choose_file(file, file.extension() != ".json");
}

bool EditorWindow::on_save() {
    files_.save();
    return true;
}

bool EditorWindow::on_control_key(const KeyPress& pressed) {
    const int key = pressed.key;
    const bool again = key == GLFW_KEY_Y || (key == GLFW_KEY_Z && (pressed.mods & GLFW_MOD_SHIFT));
    if (again)
        editor.redo(*this);
    else if (key == GLFW_KEY_Z)
        editor.undo(*this);
    else if (key == GLFW_KEY_D)
        editor.selection.set(duplicate(editor.document, editor.selection.ids));
    else if (key == GLFW_KEY_G)
        editor.group_selected(scene);
    else if (key == GLFW_KEY_O)
        show_list(browser_.shown, !browser_.shown);
    else if (key == GLFW_KEY_E)
        files_.ask_export();
    else if (key == GLFW_KEY_A)
        editor.selection.set(editor.document.at(root_entry).children);
    else if (key == GLFW_KEY_S && (pressed.mods & GLFW_MOD_SHIFT))
        files_.ask_name();
    else if (key == GLFW_KEY_F) {
        show_list(browser_.shown, false);
        tree_.begin_search();
    } else if (const EntryId active = editor.selection.active(); key == GLFW_KEY_R && active > root_entry) {
        show_list(browser_.shown, false);
        tree_.begin_renaming(active);
    } else
        return false;
    editor.selection.drop_missing(editor.document);
    return true;
}

bool EditorWindow::on_shift_key(int key) {
    const EntryId active = editor.selection.active();
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_3) {
        add_light(static_cast<Light::Kind>(key - GLFW_KEY_1));
        return true;
    }
    if (key == GLFW_KEY_4) {
        scatter_lights();
        return true;
    }
    if (!editor.document.find(active)) return false;
    if (key == GLFW_KEY_H) {
        set_hidden(editor.document, editor.selection.ids, !editor.document.at(active).hidden);
        return true;
    }
    if (key == GLFW_KEY_L) {
        set_locked(editor.document, editor.selection.ids, !editor.document.at(active).locked);
        return true;
    }
    return false;
}

bool EditorWindow::on_key(const KeyPress& pressed) {
    const int key = pressed.key;
    leaving_ = leaving_ && key == GLFW_KEY_ESCAPE;
    if (files_.asks()) {  // which is answered first
        files_.answer(key);
        return true;
    }
    if (key == GLFW_KEY_ESCAPE && fields_.drags()) {
        fields_.take_drag_back();
        return true;
    }
    ++editor.gesture;
    if (pressed.mods & GLFW_MOD_CONTROL) return on_control_key(pressed);
    if ((pressed.mods & GLFW_MOD_SHIFT) && on_shift_key(key)) return true;
    const bool in_list = shows_list();  // instead of the tree, and with keys of its own
    switch (key) {
        case GLFW_KEY_UP:
        case GLFW_KEY_DOWN:
            return !in_list && (tree_.walk(key == GLFW_KEY_UP ? -1 : 1), true);
        case GLFW_KEY_LEFT:
        case GLFW_KEY_RIGHT:
            return !in_list && (tree_.unfold_chosen(key == GLFW_KEY_RIGHT), true);
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            editor.end_drag(true);  // else it would continue below the text field
            return !in_list && (properties_.wants_keyboard = true);
        case GLFW_KEY_1:
            editor.tool = Tool::move;
            return true;
        case GLFW_KEY_2:
            editor.tool = Tool::rotate;
            return true;
        case GLFW_KEY_3:
            editor.tool = Tool::scale;
            return true;
        case GLFW_KEY_L:
            editor.local = !editor.local;
            return true;
        case GLFW_KEY_F1:
            show_list(keys_.shown, !keys_.shown);
            return true;
        case GLFW_KEY_F4:
            show_list(steps_.shown, !steps_.shown);
            return true;
        case GLFW_KEY_DELETE:
            editor.remove_selected();
            return true;
        case GLFW_KEY_F:
            frame_selected();
            return true;
        case GLFW_KEY_ESCAPE:
            return on_escape();
        default:
            return false;
    }
}

// Ends the latest action first.
bool EditorWindow::on_escape() {
    if (editor.drag) {
        editor.end_drag(false);
    } else if (loading_.loads()) {
        loading_.cancel();
    } else if (shows_list()) {
        show_list(browser_.shown, false);
    } else {
        if (editor.selection.ids.empty()) return !leaves();
        editor.selection.clear();
    }
    return true;
}

// Unsaved changes are asked about; else one Escape too many would close the window without a word.
bool EditorWindow::leaves() {
    if (editor.store.has_unsaved(editor.document) || std::exchange(leaving_, true)) return true;
    editor.notice = "Esc again closes the window";
    return false;
}

void EditorWindow::frame_selected() {
    const Bounds box = editor.selected_bounds(scene);
    const glm::vec2 size(view_.picture.size);
    CameraControl::frame(camera, box.empty() ? scene.bounds : box, size.x / size.y);
}

void EditorWindow::bring_up_to_date(Gpu& gpu) {
    if (!std::exchange(view_.gpu, &gpu)) {
        // In a window, and where no other scene was asked for, the tour has one of its own.
        const std::filesystem::path& shown = editor.store.path;
        if (automatic && !scene_is_given && tour_.shown() && !shown.empty() &&
            find_asset(shown) == find_asset(default_scene()))
            opens = find_asset(Tour::scene);
    }
    Playground::bring_up_to_date(gpu);
    files_.export_due();
}

// Called each frame: also loads files and autosaves.
bool EditorWindow::is_busy() {
    files_.keep_time();
    loading_.carry_on();
    return view_.changed || loading_.loads() || properties_.ball.is_due() ||
           (browser_.shown && browser_.thumbnails.busy());
}

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

namespace {

constexpr float click_px = 4.0f;  // a press that moved less is a click

}  // namespace

bool EditorPointer::move(const Input& input, glm::vec2 cursor_px, bool over_picture) {
    take_picked();
    view_.pointer = over_picture ? std::optional(cursor_px) : std::nullopt;
    const View& view = view_.chapter.view_now;
    if (view.size.x == 0) return false;
    const bool pressed = input.left && !was_down_, released = !input.left && was_down_;
    was_down_ = input.left;
    if (pressed) {
        ++editor.gesture;
        press_px_ = cursor_px;
        moved_px_ = 0.0f;
        pressed_on_picture_ = over_picture;
    }
    if (input.left || released) moved_px_ = std::max(moved_px_, glm::length(cursor_px - press_px_));
    const auto place = gizmo_place(editor.document, editor.selection, view, editor.tool, editor.local, editor.scale);
    if (place) tool_ = place->tool;
    if (!editor.drag) {
        const Handle before = editor.hot;
        if (!input.left || pressed)
            editor.hot =
                over_picture && place && view_.chapter.marks.on ? handle_at(*place, view, cursor_px) : Handle{};
        view_.changed |= editor.hot != before;
        if (pressed && over_picture && editor.hot && place) {
            editor.begin_drag(*place, editor.hot, view, cursor_px);
            dragged_ = true;
        }
    }
    editor.drop_drag_of_closed_step();
    if (editor.drag) return drag(input, cursor_px, released);
    if (std::exchange(dragged_, dragged_ && input.left)) return true;  // the click that ended the drag must not orbit
    if (released && pressed_on_picture_ && over_picture && moved_px_ < click_px) choose_at(cursor_px, input.shift);
    return false;
}

bool EditorPointer::drag(const Input& input, glm::vec2 cursor_px, bool released) {
    if (input.left || released) editor.drag->move(view_.chapter.view_now, cursor_px, input.shift);
    const bool clicked = released && moved_px_ < click_px;
    if (clicked) {  // no drag happened: pick below the handle
        editor.end_drag(false);
        choose_at(cursor_px, input.shift);
    } else if (released) {
        log_event("dragged " + editor.drag->words());
        editor.end_drag(true);
    }
    dragged_ = input.left;
    view_.changed = true;
    return true;
}

std::vector<std::string> EditorPointer::words() const {
    if (editor.drag) return {editor.drag->words(), "Shift: in steps", "Esc: as it was"};
    if (!editor.hot) return {};
    static constexpr const char *verbs[] = {"move", "turn", "scale"}, *axes[] = {"x", "y", "z"};
    const std::string verb = std::string("drag: ") + verbs[static_cast<int>(tool_)];
    const char* const steps = tool_ == Tool::rotate ? "Shift: by 15°" : "Shift: in steps";
    switch (editor.hot.kind) {
        case Handle::Kind::whole:
            return {verb + (tool_ == Tool::scale ? " all axes alike" : " in the picture"), steps};
        case Handle::Kind::plane:
            return {verb + " across " + axes[editor.hot.axis], steps};
        default:
            return {verb + (tool_ == Tool::rotate ? " about " : " along ") + axes[editor.hot.axis], steps};
    }
}

void EditorPointer::take_picked() {
    Picker& picker = view_.chapter.picker;
    if (!picker.poll()) return;
    editor.select_item(scene, picker.item, adds_);
    const auto& ids = editor.selection.ids;
    log_event("picked " + (ids.empty() ? "nothing" : shown_name(editor.document.at(editor.selection.active()))));
    view_.changed = true;
}

// A light's circle, or the next frame's pick.
void EditorPointer::choose_at(glm::vec2 cursor_px, bool add) {
    view_.changed = true;
    const auto light_id = editor.light_at(view_.chapter.view_now, cursor_px);
    if (!light_id) {
        adds_ = add;
        view_.chapter.click = glm::ivec2(cursor_px);
    } else if (add)
        editor.selection.toggle(*light_id);
    else
        editor.selection.set({*light_id});
}

}  // namespace lightwalk
