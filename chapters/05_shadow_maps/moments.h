// Moment maps, which are blurred instead of depth.
#pragma once
#include "05_shadow_maps/blur.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Gaussian blur with `radius` texels to each side (0 to 16), cut off at 2.5 standard deviations.
Blur blur_of(int radius, float exponent, float exponent_negative);

// [moment_maps]
/// Blurred moments of a depth map's layers, with mips.
class MomentMaps {
  public:
    /// Images for all layers of `map`; true if they were recreated.
    bool ensure(Gpu& gpu, const Image& map, VkFormat format);

    /// Moments of one layer, seen by entry `view` of `views`. `macros`: the module Shadow's, which select moments,
    /// format and blur.
    void record(Frame& frame, const ImageView& layer, const Buffer& views, uint32_t view, Blur blur,
                const Macros& macros);

    Image moments;

  private:
    Image between_;  ///< after the blur along u
    Pipeline first_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "0"}}});
    Pipeline second_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "1"}}});
    Pipeline halve_ = compute({.shader = "05_shadow_maps/halve_moments.comp"});
};
// [/moment_maps]

}  // namespace lightwalk
