// The part of the editor's picture that an output of another shape has.
#pragma once
#include <string>
#include <vector>

#include "common/scene/camera.h"
#include "common/window/blit.h"

namespace lightwalk {

class OutputFrame {
  public:
    /// Names of shapes, the window's own first.
    static const std::vector<const char*>& names();

    size_t shape = 0;  ///< of names()

    /// The camera that shows all of the output in a picture of `size` pixels: where that is narrower, it sees more.
    Camera seen(const Camera& camera, glm::uvec2 size) const;
    /// The output in that picture.
    Area area(glm::uvec2 size) const;

    /// Darkens what is outside of it. `picture` in the window.
    void draw(const Area& picture, float scale) const;
};

}  // namespace lightwalk
