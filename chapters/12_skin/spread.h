// Spreading of light in a surface, computed on the map of the surface.
#pragma once
#include "12_skin/exercises.h"

namespace lightwalk {

// [spread]
class Spread {
  public:
    /// Maps of one size: the light that enters, with the number of its chart in alpha (0: none); texels per mm along u
    /// and v and a texel's mm²; where it lies in metres, with the chart again.
    struct Maps {
        const Image &irradiance, &stretch, &position;
    };

    /// Records the light that leaves, as a sum of 1, 2, 3, 4 or 6 Gaussians; 0: every texel from every texel, in 32
    /// bits.
    void record(Frame& frame, const Maps& maps, int gaussians);
    // [/spread]

    /// Of the last record(): none before it. Levels are a sum's Gaussians, narrow ones first.
    const Image& result() const { return exactly_ ? exact_ : sum_; }
    const Image& level(size_t i) const { return levels_.at(std::min(i, levels_.size() - 1)); }

  private:
    void record_exactly(Frame& frame, const Maps& maps);
    bool exactly_ = false;
    Image between_, sum_, exact_;
    std::vector<Image> levels_;
    Pipeline line_ = compute({.shader = "12_skin/blur.comp", .macros = {{"PER_CHANNEL", "0"}}});
    Pipeline line_per_channel_ = compute({.shader = "12_skin/blur.comp", .macros = {{"PER_CHANNEL", "1"}}});
    Pipeline add_up_ = compute({.shader = "12_skin/sum.comp"});
    Pipeline every_texel_ = compute({.shader = "12_skin/exact.comp"});
};

}  // namespace lightwalk
