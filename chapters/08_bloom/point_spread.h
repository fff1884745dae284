// Point-spread error of a blur: its image of one bright pixel against the reference.
#pragma once
#include <map>

#include "08_bloom/bloom.h"
#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

class PointSpread {
  public:
    /// Draws the bright pixel into frame.hdr, so far to the right of the middle.
    void draw_spot(Frame& frame, float x_px) const;

    /// How far the chapter's picture is from that of the method `exact`: the root of the sum of squared differences
    /// over that of the exact squares, 0 to about 1. Sets bloom.method, and leaves it to the caller to put it back.
    double error(Chapter& chapter, Bloom& bloom, Gpu& gpu, glm::uvec2 size);

  private:
    Pipeline spot_ = compute({.shader = "08_bloom/spot.comp"});
    std::map<std::string, ImageRgb> exact_;  ///< key of the reference
};

/// The root of the sum of (found - exact)² over that of exact²; linear light, green. Of one size.
double relative_l2(const ImageRgb& found, const ImageRgb& exact);

}  // namespace lightwalk
