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
    if (input.left || released) moved_px_ = std::max(moved_px_, glm::length(cursor_px - press_px_));
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
            choose_at(cursor_px, input.shift);
        } else if (released) {
            log_event("dragged " + editor.drag->words());
            editor.end_drag(true);
        }
        dragged_ = input.left;
        changed_ = true;
        return true;
    }
    if (std::exchange(dragged_, dragged_ && input.left)) return true;  // what ended the drag is no reason to orbit
    if (released && pressed_on_picture_ && over_picture && moved_px_ < click_px) choose_at(cursor_px, input.shift);
    return false;
}
// [/mouse]

// A light's circle, or what the next frame finds there.
void EditorWindow::choose_at(glm::vec2 cursor_px, bool add) {
    changed_ = true;
    const auto light_id = editor.light_at(view_now, cursor_px);
    if (!light_id)
        adds_ = add, click = glm::ivec2(cursor_px);
    else if (add)
        editor.selection.toggle(*light_id);
    else
        editor.selection.set({*light_id});
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
        browser_.shown = !browser_.shown;
    else if (key == GLFW_KEY_E)
        on_export();
    else if (key == GLFW_KEY_A)
        editor.selection.set(editor.document.at(root_entry).children);
    else if (key == GLFW_KEY_S && (pressed.mods & GLFW_MOD_SHIFT))
        save_as();
    else if (key == GLFW_KEY_F)
        searches_ = true;
    else if (const EntryId active = editor.selection.active(); key == GLFW_KEY_R && active > root_entry)
        begin_renaming(active);
    else
        return false;
    editor.selection.drop_missing(editor.document);
    return true;
}

bool EditorWindow::on_shift_key(int key) {
    const EntryId active = editor.selection.active();
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_3)
        return editor.add_light(*this, static_cast<Light::Kind>(key - GLFW_KEY_1)), true;
    if (key == GLFW_KEY_4) return scatter_lights(), true;
    if (!editor.document.find(active)) return false;
    if (key == GLFW_KEY_H)
        return set_hidden(editor.document, editor.selection.ids, !editor.document.at(active).hidden), true;
    if (key == GLFW_KEY_L)
        return set_locked(editor.document, editor.selection.ids, !editor.document.at(active).locked), true;
    return false;
}

bool EditorWindow::on_key(const KeyPress& pressed) {
    const int key = pressed.key;
    if (question_ != Question::nothing) return answer_key_ = key, true;  // which is answered first
    if (key == GLFW_KEY_ESCAPE && drags_number_) return take_number_back(), true;
    ++editor.gesture;
    if (pressed.mods & GLFW_MOD_CONTROL) return on_control_key(pressed);
    if ((pressed.mods & GLFW_MOD_SHIFT) && on_shift_key(key)) return true;
    const bool in_files = browser_.shown;  // which has arrows and Enter of its own
    switch (key) {
        case GLFW_KEY_UP:
        case GLFW_KEY_DOWN:
            return !in_files && (walk_tree(key == GLFW_KEY_UP ? -1 : 1), true);
        case GLFW_KEY_LEFT:
        case GLFW_KEY_RIGHT:
            return !in_files && (unfold_chosen(key == GLFW_KEY_RIGHT), true);
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            editor.end_drag(true);  // else it would go on below what is typed
            return !in_files && (types_ = true);
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
        case GLFW_KEY_F4:
            shows_steps_ = !shows_steps_;
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
            if (browser_.shown || shows_keys_ || shows_steps_)
                return browser_.shown = shows_keys_ = shows_steps_ = false, true;
            if (editor.selection.ids.empty()) return false;
            return editor.selection.clear(), true;
        default:
            return false;
    }
}

// All that a drag over a number has changed. The mouse may still be held: it drags no more.
void EditorWindow::take_number_back() {
    editor.document.take_back(editor.gesture);
    stops_drag_ = true, drags_number_ = false;
}

// What the scene has once stands in the tree too, before all others.
void EditorWindow::walk_tree(int by) {
    std::vector<EntryId> ids{root_entry};
    std::vector<std::string> names{""};
    for (const std::string& one : facet_names()) ids.push_back(root_entry), names.push_back(one);
    for (const TreeRow& row : editor.tree.rows(editor.document))
        if (row.node < 0) ids.push_back(row.id), names.emplace_back();
    const EntryId active = editor.selection.active();
    int now = by < 0 ? static_cast<int>(ids.size()) : -1;
    for (size_t i = 0; i < ids.size(); ++i)
        if (ids[i] == active && (active != root_entry || names[i] == facet_)) now = static_cast<int>(i);
    const auto next = static_cast<size_t>(std::clamp(now + by, 0, static_cast<int>(ids.size()) - 1));
    editor.selection.set({ids[next]});
    facet_ = names[next];
    last_clicked_ = ids[next];
}

void EditorWindow::unfold_chosen(bool open) {
    if (const EntryId active = editor.selection.active(); active != no_entry) editor.tree.unfold(active, open);
}

void EditorWindow::frame_selected() {
    const Bounds box = editor.selected_bounds(scene);
    const glm::vec2 size(picture_);
    // Its middle is the picture's, about which the camera turns: as much is free on the right as the panel leaves on the left.
    const float free = std::max(size.x - 2.0f * covered_px_, 0.4f * size.x);
    CameraControl::frame(camera, box.empty() ? scene.bounds : box, free / size.y);
}

bool EditorWindow::may_close() {
    if (closes_ || !editor.store.has_unsaved(editor.document)) return editor.store.forget_autosave(), true;
    question_ = Question::close;
    changed_ = true;
    return false;
}

// Besides, time goes by here: files are loaded, and every 30 s what is not saved is written beside the file.
bool EditorWindow::is_busy() {
    check_recovery();
    load_beside_the_picture();
    const bool busy = changed_ || !wanted_.empty() || ball_scene_ || (browser_.shown && browser_.thumbnails.busy());
    if (now_s() < next_autosave_ || editor.drag) return busy;
    if (next_autosave_ != 0) try {
            Said said;
            if (editor.store.autosave(editor.document, &said)) log_event("autosaved");
            say(said);
        } catch (const InputError& e) { editor.notice = "not saved by itself: " + std::string(e.what()); }
    next_autosave_ = now_s() + autosave_every_s;
    return busy;
}

}  // namespace lightwalk
