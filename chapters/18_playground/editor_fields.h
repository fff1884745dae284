// Fields of the editor's panels: a typed value counts once, when the field is left.
#pragma once
#include <map>

#include "18_playground/editor_part.h"

namespace lightwalk {

/// Numbers, colours, switches and lists. `mixed`: a dash stands for differing values of several entries. True if the
/// value was changed.
class EditorFields : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// `most`: a word for the largest value, which stands for no limit.
    bool number(const char* label, const char* help, float& value, float speed, float lower, float upper,
                bool mixed = false, const char* most = "%.5g");
    bool numbers(const char* label, const char* help, glm::vec3& value, float speed,
                 glm::bvec3 mixed = glm::bvec3(false));
    bool color(const char* label, const char* help, glm::vec3& value, float most, glm::bvec3 mixed = glm::bvec3(false));
    bool check(const char* label, const char* help, bool& on, bool mixed);
    bool choice(const char* label, std::initializer_list<const char*> names, float& index, bool mixed);

    /// A refusal is reported once while a number is dragged, although it recurs each frame.
    void refuse(const Said& said) {
        if (std::exchange(refused_, said) != said) say(said);
    }

    void begin_frame();  ///< before the first field
    bool drags() const { return drags_; }
    /// All that a drag over a number has changed. The mouse may still be held: it drags no more.
    void take_drag_back();

  private:
    bool once_left(
        uint32_t field, float* values, int count, const std::function<bool()>& widget,
        const std::function<bool()>& has_list = [] { return false; });
    bool three_numbers(glm::vec3& value, float right, float speed, float lower, float upper, glm::bvec3 mixed);
    bool takes(const char* label, float* values, int count, const float* before, float lower, float upper);

    /// Numbers that somebody types.
    struct Typed {
        uint32_t item = 0;  ///< within the field
        int frame = -1;     ///< that has drawn it last
        glm::vec3 values{0.0f};
    };
    std::map<uint32_t, Typed> typed_;  ///< by field: where one is left for another, both are there for a frame
    std::string refused_;
    bool drags_ = false, stops_drag_ = false;  ///< with the mouse, in the frame drawn last; the next one ends it
};

}  // namespace lightwalk
