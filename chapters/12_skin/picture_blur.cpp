#include "12_skin/picture_blur.h"

#include <cmath>

#include "12_skin/sums.h"

namespace lightwalk {

void PictureBlur::record(Frame& frame, float fov_y_rad) {
    constexpr int side = 8;
    if (!kernel_) kernel_ = frame.gpu.upload("skin line", line_kernel(side));
    const float pixels_at_1m = 0.5f * static_cast<float>(frame.crop.whole.y) / std::tan(0.5f * fov_y_rad);
    ScreenBlur blur{.direction = {1, 0}, .taps = 2 * side + 1, .pixels_at_1m = pixels_at_1m, .edge_mm = 5.0f};
    frame.compute("skin separable", {.reads = {light, half_, after, frame.hdr}, .writes = {light, half_, frame.hdr}},
                  [&](Compute& pass) {
                      pass.use(line_).set("from", light, linear_clamp).set("into", half_).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(frame.size).wait();
                      blur.direction = {0, 1};
                      pass.use(line_).set("from", half_, linear_clamp).set("into", light).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(frame.size).wait();
                      pass.use(add_).set("light", light, nearest_clamp).set("after", after, nearest_clamp);
                      pass.set("hdr", frame.hdr).dispatch_threads(frame.size);
                  });
}

}  // namespace lightwalk
