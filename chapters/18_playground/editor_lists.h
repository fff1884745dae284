// Lists that a key opens where the tree is otherwise: all steps by name, and all keys.
#pragma once
#include "18_playground/editor_part.h"

namespace lightwalk {

/// A click goes back or forward to where a step was done.
class StepsPanel : public EditorPart {
  public:
    using EditorPart::EditorPart;
    void draw();
    bool shown = false;

  private:
    size_t listed_ = SIZE_MAX;  ///< the step that the list was scrolled to last
};

class KeysPanel : public EditorPart {
  public:
    KeysPanel(EditorView& view, std::function<void()> tour) : EditorPart(view), tour_(std::move(tour)) {}
    void draw();
    bool shown = false;

  private:
    std::function<void()> tour_;  ///< begins it
};

}  // namespace lightwalk
