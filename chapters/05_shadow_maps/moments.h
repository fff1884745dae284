// Moment maps, which are blurred instead of depth.
#pragma once
#include "05_shadow_maps/blur.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// A Gaussian blur over `radius` texels to each side (0 to 16), which ends at two and a half times its width.
Blur blur_of(int radius, float exponent, float exponent_negative);

// [moment_maps]
/// The layers of a map of depths as moments, blurred, with mips.
class MomentMaps {
  public:
    /// Creates as many layers as in `map`, of its size, unless they are there. True: they are new.
    bool ensure(Gpu& gpu, const Image& map, VkFormat format);

    /// Moments of one layer of the map, which view number `view` of `views` sees. `macros` are the module Shadow's:
    /// they say which moments, in which format, and how to blur.
    void record(Frame& frame, const ImageView& layer, const Buffer& views, uint32_t view, Blur blur,
                const Macros& macros);

    Image moments;

  private:
    Image between_;  ///< blurred along u
    Pipeline first_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "0"}}});
    Pipeline second_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "1"}}});
    Pipeline halve_ = compute({.shader = "05_shadow_maps/halve_moments.comp"});
};
// [/moment_maps]

}  // namespace lightwalk
