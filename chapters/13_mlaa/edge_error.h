// Error of the edge pixels of a picture.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>

#include "13_mlaa/mlaa.h"
#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

/// Over the pixels that 64 samples make another than one in their middle does, by more than 1/64 of white in a channel:
/// the root of the mean squared difference from 64 samples, linear light; and over all others the largest step of 1/255
/// by which the picture is another than with one sample.
struct EdgePixels {
    double rmse = 0, share = 0, off_edges = 0;
};
EdgePixels compare_edges(const ImageRgb& found, const ImageRgb& one_sample, const ImageRgb& truth);

/// All that a picture without anti-aliasing depends on, as text: for truths that are kept.
std::string drawn_with(const Chapter& chapter, const Mlaa& antialias, glm::uvec2 size);

class EdgeError {
  public:
    /// Adds edge_rmse and mixed (the share of pixels that the filter mixed) to `error`, for the chapter's current
    /// knobs. Sets its method and samples; the caller restores them.
    void measure(Chapter& chapter, Mlaa& antialias, Gpu& gpu, glm::uvec2 size, nlohmann::json& error);

  private:
    struct Pair {
        ImageRgb one_sample, truth;
    };
    std::map<std::string, Pair> known_;  ///< by their dependencies
};

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
