#include "18_playground/editor_window.h"

#include <GLFW/glfw3.h>

#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/camera_control.h"

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
    loading_.was_shown();
}

// Called each frame: also loads files and autosaves.
bool EditorWindow::is_busy() {
    files_.keep_time();
    loading_.carry_on();
    return view_.changed || loading_.loads() || properties_.ball.is_due() ||
           (browser_.shown && browser_.thumbnails.busy());
}

}  // namespace lightwalk
