// A pyramid of the farthest depths, for tests of what is hidden.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

// [depth_pyramid]
/// Texels of mip m hold the farthest (smallest) depth of 2^(m+1) pixels in each direction; the last ones also cover odd
/// remainders. Five levels take one dispatch.
class DepthPyramid {
  public:
    explicit DepthPyramid(std::string name) : name_(std::move(name)) {}

    /// `depth`: reversed, any size. The result is valid in later frames.
    void record(Frame& frame, const ImageView& depth);

    const Image& image() const { return image_; }  ///< R32F; its first mip has half of the depth's size
    /// Size of the depth image in pixels; 0 before the first record().
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
