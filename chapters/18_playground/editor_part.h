// Shared state of the parts of the editor's window.
#pragma once
#include <functional>

#include "18_playground/playground.h"
#include "common/window/window_tool.h"

namespace lightwalk {

/// The picture beside the panels, and the panels' requests to the window.
struct EditorView {
    Playground& chapter;
    Gpu* gpu = nullptr;  ///< of the frames
    glm::uvec2 picture{960, 540};
    float covered_px = 0;                        ///< of the picture, by the panel on the left
    bool changed = false;                        ///< the picture has to be drawn again
    AutoChoices* automatic;                      ///< the window's, for knobs in panels
    std::function<void(const KeyPress&)> press;  ///< a key's action, for menus
};

/// A part of the window. It owns its state; the document and the scene belong to the editor.
class EditorPart {
  public:
    explicit EditorPart(EditorView& view) : view_(view), editor(view.chapter.editor), scene(view.chapter.scene) {}
    EditorPart(const EditorPart&) = delete;

  protected:
    void say(const Said& said) {
        if (!said.empty()) editor.notice = said;
    }
    EditorView& view_;
    Editor& editor;
    Scene& scene;
};

}  // namespace lightwalk
