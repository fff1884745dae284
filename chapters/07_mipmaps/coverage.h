// Alpha scale of the levels of a cutout, which keeps the share of visible texels constant.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// A level as shaders read and write it: all layers, no encoding.
inline ImageView plain_level(const ImageView& image, uint32_t level) { return image.mip(level).as_array().codes(); }

class Coverage {
  public:
    /// Multiplies the alpha of the view's levels from its second on, which are the means by now. Waits for nothing on
    /// the host.
    void record(Frame& frame, const ImageView& image, float cutoff);

  private:
    static Pipeline step(const char* number) {
        return compute(
            {.shader = "07_mipmaps/coverage.comp", .macros = {{"STEP", number}, {"RESULT_FORMAT", "rgba8"}}});
    }
    Pipeline clear_ = compute({.shader = "07_mipmaps/clear_words.comp"});
    Pipeline count_ = step("0"), find_ = step("1"), scale_ = step("2");
    Buffer counts_, factors_;
};

}  // namespace lightwalk
