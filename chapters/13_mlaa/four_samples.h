// Four samples a pixel while the picture is drawn: what filters of finished pictures are measured against.
#pragma once
#include <functional>

#include "common/app/module.h"
#include "common/app/target.h"
#include "common/gpu/frame.h"

namespace lightwalk {

class FourSamples {
  public:
    explicit FourSamples(Module& owner) : sum_(owner, {.name = "sum", .format = VK_FORMAT_R32G32B32A32_SFLOAT}) {}

    /// Multisampling: each triangle covers some of a pixel's four samples and is shaded once for them. Targets of a
    /// raster pass whose mean, when it ends, is in `into`; what was cleared is `background`.
    RasterTargets multisampled(Frame& frame, const Image& into, const glm::vec4& background);

    /// Supersampling: `draw` four times, each with frame.crop shifted to another of the pixel's samples, which lie in
    /// four rows and four columns. Then frame.hdr is the mean.
    void supersample(Frame& frame, const std::function<void()>& draw);

  private:
    Image color_, depth_;
    Target sum_;
    Pipeline add_ = compute({.shader = "13_mlaa/add.comp"});
};

}  // namespace lightwalk
