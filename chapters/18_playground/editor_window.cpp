#include "18_playground/editor_window.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <chrono>

#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/camera_control.h"

namespace lightwalk {
namespace {

constexpr double autosave_every_s = 30.0;
constexpr float click_px = 4.0f;  // a press that moved less is a click

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

// [mouse]
bool EditorWindow::on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) {
    if (picker.poll()) {
        editor.select_item(scene, picker.item, adds_);
        log_event("picked " + (editor.selection.ids.empty()
                                   ? "nothing"
                                   : shown_name(editor.document.at(editor.selection.active()))));
        changed_ = true;
    }
    if (view_now.size.x == 0) return false;
    const bool pressed = input.left && !was_down_, released = !input.left && was_down_;
    was_down_ = input.left;
    if (pressed) ++editor.gesture, press_px_ = cursor_px, moved_px_ = 0.0f, pressed_on_picture_ = over_picture;
    if (input.left) moved_px_ = std::max(moved_px_, glm::length(cursor_px - press_px_));
    const auto place = gizmo_place(editor.document, editor.selection, view_now, editor.tool, editor.local);
    if (!editor.drag) {
        const Handle before = editor.hot;
        if (!input.left || pressed)
            editor.hot = over_picture && place && marks.on ? handle_at(*place, view_now, cursor_px) : Handle{};
        changed_ |= editor.hot != before;
        if (pressed && over_picture && editor.hot && place) {
            editor.begin_drag(*place, editor.hot, view_now, cursor_px);
            dragged_ = true;
        }
    }
    editor.drop_drag_of_closed_step();
    if (editor.drag) {
        if (input.left) editor.drag->move(view_now, cursor_px, input.shift);
        const bool clicked = released && moved_px_ < click_px;
        if (clicked) {  // nobody has dragged: what lies below the handle is meant
            editor.end_drag(false);
            adds_ = input.shift;
            click = glm::ivec2(cursor_px);
        } else if (released) {
            log_event("dragged " + editor.drag->words());
            editor.end_drag(true);
        }
        dragged_ = input.left;
        changed_ = true;
        return true;
    }
    if (std::exchange(dragged_, dragged_ && input.left)) return true;  // what ended the drag is no reason to orbit
    if (released && pressed_on_picture_ && over_picture && moved_px_ < click_px) {
        adds_ = input.shift;
        if (const auto light_id = editor.light_at(view_now, cursor_px)) {
            if (adds_)
                editor.selection.toggle(*light_id);
            else
                editor.selection.set({*light_id});
        } else {
            click = glm::ivec2(cursor_px);
        }
        changed_ = true;
    }
    return false;
}
// [/mouse]

bool EditorWindow::on_key(const KeyPress& pressed) {
    const int key = pressed.key;
    ++editor.gesture;
    if (pressed.mods & GLFW_MOD_CONTROL) {
        const bool again = key == GLFW_KEY_Y || (key == GLFW_KEY_Z && (pressed.mods & GLFW_MOD_SHIFT));
        if (again)
            editor.redo(*this);
        else if (key == GLFW_KEY_Z)
            editor.undo(*this);
        else if (key == GLFW_KEY_D)
            editor.selection.set(duplicate(editor.document, editor.selection.ids));
        else if (key == GLFW_KEY_G)
            editor.selection.set({group(editor.document, editor.selection.ids, "group")});
        else if (key == GLFW_KEY_O)
            browser_.shown = !browser_.shown;
        else if (key == GLFW_KEY_E)
            try {
                editor.export_to(scene, save_name_.substr(0, save_name_.rfind('.')) + ".gltf");
            } catch (const InputError& e) { editor.notice = e.what(); }
        else if (key == GLFW_KEY_A)
            editor.selection.set(editor.document.at(root_entry).children);
        else
            return false;
        editor.selection.drop_missing(editor.document);
        return true;
    }
    switch (key) {
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
            shows_keys_ = !shows_keys_;
            return true;
        case GLFW_KEY_DELETE:
            say(remove(editor.document, editor.selection.ids));
            editor.selection.drop_missing(editor.document);
            return true;
        case GLFW_KEY_F:
            return frame_selected(), true;
        case GLFW_KEY_ESCAPE:
            if (editor.drag) return editor.end_drag(false), true;
            if (!wanted_.empty()) return stop_loading("cancelled: " + wanted_.front().file.filename().string()), true;
            if (browser_.shown || shows_keys_) return browser_.shown = shows_keys_ = false, true;
            if (editor.selection.ids.empty()) return false;
            return editor.selection.clear(), true;
        default:
            return false;
    }
}

void EditorWindow::frame_selected() {
    const Bounds box = editor.selected_bounds(scene);
    const glm::vec2 size(picture_);
    CameraControl::frame(camera, box.empty() ? scene.bounds : box, size.x / size.y);
}

bool EditorWindow::on_save() {
    editor.end_drag(true);
    try {
        if (!overwrites_ && editor.store.changed_on_disk()) {
            question_ = Question::overwrite;
            changed_ = true;
            return true;
        }
        overwrites_ = false;
        const bool own = !editor.store.path.empty() && !lies_below(editor.store.path, course_root() / "assets");
        if (!own && file_exists(save_name_) && question_ != Question::overwrite) {
            question_ = Question::overwrite;
            return true;
        }
        editor.save(*this, own ? std::filesystem::path() : std::filesystem::path(save_name_));
        remember_file(editor.store.path);
        log_event("saved " + std::filesystem::absolute(editor.store.path).string());
    } catch (const InputError& e) {
        editor.notice = "not saved: " + std::string(e.what());
        log_event("not saved");
    }
    return true;
}

bool EditorWindow::may_close() {
    if (closes_ || !editor.store.has_unsaved(editor.document)) return true;
    question_ = Question::close;
    changed_ = true;
    return false;
}

// Besides, time goes by here: every 30 s what is not saved is written beside the file.
bool EditorWindow::is_busy() {
    check_recovery();
    const bool busy = changed_ || !wanted_.empty() || ball_scene_ || (browser_.shown && browser_.thumbnails.busy());
    if (now_s() < next_autosave_ || editor.drag) return busy;
    if (next_autosave_ != 0) try {
            if (editor.store.autosave(editor.document)) log_event("autosaved");
        } catch (const InputError& e) { editor.notice = "not saved by itself: " + std::string(e.what()); }
    next_autosave_ = now_s() + autosave_every_s;
    return busy;
}

void EditorWindow::check_recovery() {
    if (std::exchange(checked_recovery_, true)) return;
    browser_.chosen = [this](const std::filesystem::path& file, bool adds) { want(file, adds); };
    if (editor.store.has_recovery()) question_ = Question::recover;
}

}  // namespace lightwalk
