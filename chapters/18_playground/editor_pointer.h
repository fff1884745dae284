// The mouse over the editor's picture: picking, and the gizmo's handles.
#pragma once
#include "18_playground/editor_part.h"

namespace lightwalk {

class EditorPointer : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// True: taken, and the camera stays.
    bool move(const Input& input, glm::vec2 cursor_px, bool over_picture);
    std::vector<std::string> words() const;  ///< what a drag does from here; none: it moves the camera

  private:
    void take_picked();
    bool drag(const Input& input, glm::vec2 cursor_px, bool released);
    void choose_at(glm::vec2 cursor_px, bool add);
    bool was_down_ = false, pressed_on_picture_ = false, dragged_ = false, adds_ = false;
    glm::vec2 press_px_{0.0f};
    float moved_px_ = 0;
    Tool tool_ = Tool::move;  ///< of the gizmo: a sun is turned only
};

}  // namespace lightwalk
