// Four samples per pixel while the picture is rendered, for comparison with filters of finished pictures.
#pragma once
#include <functional>

#include "01_obj/camera_view.h"
#include "common/app/drawing.h"
#include "common/app/target.h"

namespace lightwalk {

class FourSamples {
  public:
    explicit FourSamples(Module& owner) : sum_(owner, {.name = "sum", .format = VK_FORMAT_R32G32B32A32_SFLOAT}) {}

    /// Multisampling: each triangle covers some of a pixel's four samples and is shaded once for them. Applies to all
    /// later drawing into the canvas.
    void multisample(Frame& frame, Canvas& canvas) {
        Device& device = frame.gpu.device;
        color_.ensure(device, {.name = "four colours", .size = canvas.size(), .samples = 4});
        depth_.ensure(device,
                      {.name = "four depths", .format = VK_FORMAT_D32_SFLOAT, .size = canvas.size(), .samples = 4});
        canvas.multisampled(color_, depth_);
    }

    /// Supersampling: the view four times, each shifted to another of the pixel's samples, which lie in four rows and
    /// four columns; `draw` draws one into frame.hdr. Then frame.hdr is the mean.
    void supersample(Frame& frame, const View& view, const std::function<void(const View&)>& draw) {
        const glm::vec2 places[] = {{-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};
        for (int i = 0; i < 4; ++i) {
            Crop crop = view.crop;
            crop.shift += places[i];
            View shifted = view_of(view.camera, view.size, crop);
            shifted.id = view.id;
            draw(shifted);
            frame.compute("add sample", {.reads = {frame.hdr, sum_}, .writes = {frame.hdr, sum_}}, [&](Compute& pass) {
                pass.use(add_).set("sample_index", i).set("hdr", frame.hdr).set("sum", sum_);
                pass.dispatch_threads(view.size);
            });
        }
    }

  private:
    Image color_, depth_;
    Target sum_;
    Pipeline add_ = compute({.shader = "13_mlaa/add.comp"});
};

}  // namespace lightwalk
