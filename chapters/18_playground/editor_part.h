// Shared state of the parts of the editor's window.
#pragma once
#include <chrono>
#include <functional>

#include "15_terrain_water/ground_heights.h"
#include "18_playground/playground.h"
#include "common/window/window_tool.h"

namespace lightwalk {

/// The picture beside the panels, and the panels' requests to the window.
struct EditorView {
    Playground& chapter;
    Gpu* gpu = nullptr;                          ///< of the frames
    Area picture{{0, 0}, {960, 540}};            ///< of the window
    std::optional<glm::vec2> pointer;            ///< over the picture, in its pixels
    bool changed = false;                        ///< the picture has to be drawn again
    AutoChoices* automatic;                      ///< the window's, for knobs in panels
    std::function<void(const KeyPress&)> press;  ///< a key's action, for menus
    GroundHeights terrain() const { return gpu ? read_heights(*gpu, chapter.bench.ground) : GroundHeights{}; }
    /// Lets the person choose an image file for `what`.
    std::function<void(const std::string& what, const std::function<void(const std::filesystem::path&)>& take)> pick;
};

inline double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Through what the pointer shows, or the middle of the picture.
inline PickRay placing_ray(const EditorView& view) {
    const View& now = view.chapter.view_now;
    if (now.size.x == 0) return {};
    return ray_through(now, view.pointer.value_or(0.5f * glm::vec2(now.size)));
}

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
