// Four samples per pixel while the picture is rendered, for comparison with filters of finished pictures.
#pragma once
#include <functional>

#include "common/app/drawing.h"
#include "common/app/target.h"

namespace lightwalk {

class FourSamples {
  public:
    explicit FourSamples(Module& owner) : sum_(owner, {.name = "sum", .format = VK_FORMAT_R32G32B32A32_SFLOAT}) {}

    /// Multisampling: each triangle covers some of a pixel's four samples and is shaded once for them. Applies to all
    /// later drawing into the canvas.
    void multisample(Frame& frame, Canvas& canvas);

    /// Supersampling: the view four times, each shifted to another of the pixel's samples, which lie in four rows and
    /// four columns; `draw` draws one into frame.hdr. Then frame.hdr is the mean.
    void supersample(Frame& frame, const View& view, const std::function<void(const View&)>& draw);

  private:
    Image color_, depth_;
    Target sum_;
    Pipeline add_ = compute({.shader = "13_mlaa/add.comp"});
};

}  // namespace lightwalk
