#include "18_playground/editor_pointer.h"

#include "common/window/event_log.h"

namespace lightwalk {
namespace {

constexpr float click_px = 4.0f;  // a press that moved less is a click

}  // namespace

// [mouse]
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
// [/mouse]

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
