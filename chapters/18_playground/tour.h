// A tour of the editor in ten steps, below the tree.
#pragma once
#include "18_playground/editor_part.h"

namespace lightwalk {

/// A step is over once the person has done what it says. It is shown at the first start, and later on request.
class Tour : public EditorPart {
  public:
    static constexpr const char* scene = "scenes/terrace.json";

    /// Shown unless it was left before, which knob_sections.h keeps.
    explicit Tour(EditorView& view);

    void begin();
    bool shown() const { return step_ > 0; }
    float height_px(float scale) const { return shown() ? 156.0f * scale : 0.0f; }
    void draw(float width_px, float scale);

    /// What a step's end is told by.
    struct Facts {
        glm::vec3 camera{0.0f};
        size_t selected = 0, done = 0, objects = 0, lights = 0;
        Tool tool = Tool::move;
        bool sky = false, weather = false, saved = false;
    };

    /// Of step `step`, from 1 on: whether the person has done what it says since it began.
    static bool is_done(size_t step, const Facts& begin, const Facts& now);

  private:
    Facts facts() const;
    void go_to(size_t step);
    void leave();
    size_t step_ = 0;  ///< from 1 on; 0: not shown
    Facts begin_;      ///< of the step
};

}  // namespace lightwalk
