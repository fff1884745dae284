// The line below the picture: what the mouse does, the pixel under it, and messages.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "common/window/blit.h"

namespace lightwalk {

struct StatusLine {
    static constexpr int height = 46;  ///< two lines, in pixels at scale 1

    /// 0 in a window in which it would take much of the picture.
    static uint32_t height_px(float scale, uint32_t window_height);

    /// As many words as have room. No `mouse`: it moves the camera. A `notice` takes their place, and part of the picture
    /// only where it has more lines than these.
    static void draw(const Area& picture, float scale, const std::string& notice, const std::vector<std::string>& mouse,
                     const std::vector<std::string>& pixel);
};

}  // namespace lightwalk
