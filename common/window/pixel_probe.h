// One pixel of the picture in words: its object, material, linear value and depth.
#pragma once
#include <optional>

#include "common/app/chapter.h"
#include "common/scene/view.h"

namespace lightwalk {

class PixelProbe {
  public:
    /// Of the frame that was drawn last; reads back anew where the pixel or the frame is another. None: no words.
    void look(Gpu& gpu, const Frame& frame, const Chapter& chapter, std::optional<glm::uvec2> at);

    /// "412, 233", the value, the depth, the object and its material, as far as they are known.
    const std::vector<std::string>& words() const { return words_; }

  private:
    std::vector<std::string> words_;
    std::optional<glm::uvec2> at_;
    uint64_t frame_ = 0;
    double next_s_ = 0;
};

}  // namespace lightwalk
