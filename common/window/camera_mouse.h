// The camera of a window under the mouse and the keys.
#pragma once
#include "common/app/chapter.h"
#include "common/window/activity.h"
#include "common/window/window_tool.h"

namespace lightwalk {

/// A drag that begins over the panel stays with it; one over the picture goes to the camera, or to the chapter's own
/// tool.
class CameraMouse {
  public:
    CameraMouse(Chapter& chapter, Display& display, Activity& activity)
        : chapter_(chapter), display_(display), activity_(activity) {}

    /// `cursor_px`: from the corner of the picture, which has the size `picture`, in pixels. `seconds` since the last call,
    /// for keys that fly.
    void move(const Input& input, glm::vec2 cursor_px, glm::uvec2 picture, double seconds);

  private:
    bool tool_has_mouse(const Input& input, glm::vec2 cursor, glm::uvec2 picture);
    void follow_mouse(glm::vec2 place);
    void drag(const Input& input);
    void fly(const Input& input, double seconds);
    Chapter& chapter_;
    Display& display_;
    Activity& activity_;
    bool dragging_ = false;
};

}  // namespace lightwalk
