// Flicker: how differently from the truth a picture changes from frame to frame.
#pragma once
#include <map>

#include "13_mlaa/mlaa.h"
#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

/// Mean over a second of |change of the picture from frame to frame - change of the truth|, linear light, over a part in
/// the middle of the picture, a quarter as wide and as high. The truth has 16 samples a pixel in each frame.
class Flicker {
  public:
    /// For the current knobs, from time 0 on. Sets method and samples; the caller restores them.
    double measure(Chapter& chapter, Mlaa& antialias, Gpu& gpu, glm::uvec2 size);

    static constexpr int frames = 60, truth_samples = 16;

  private:
    std::map<std::string, std::vector<ImageRgb>> known_;  ///< truths by their dependencies
};

/// Mean over pixels, channels and frames.
double flicker_of(const std::vector<ImageRgb>& found, const std::vector<ImageRgb>& truth);

}  // namespace lightwalk
