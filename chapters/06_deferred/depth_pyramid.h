// A pyramid of the farthest depths, for tests of what is hidden.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

// [depth_pyramid]
/// A texel of mip m holds the farthest (smallest) depth of 2^(m+1) times as many pixels in each direction; the last ones of a
/// level also of what is left over. Five levels take one dispatch.
class DepthPyramid {
  public:
    explicit DepthPyramid(std::string name) : name_(std::move(name)) {}

    /// `depth`: reversed, of any size. Later frames may read the result.
    void record(Frame& frame, const ImageView& depth);

    const Image& image() const { return image_; }  ///< R32F; its first mip has half of the depth's size
    /// Of the depth's picture in pixels; 0 before the first record().
    glm::uvec2 pixels() const { return pixels_; }
    int levels() const { return image_ ? static_cast<int>(image_.desc.mips) : 0; }
    // [/depth_pyramid]

  private:
    std::string name_;
    Image image_;
    glm::uvec2 pixels_{0};
    Pipeline five_levels_ = compute({.shader = "06_deferred/depth_pyramid.comp"});
};

}  // namespace lightwalk
