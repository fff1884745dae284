#include "12_skin/picture_blur.h"

#include <utility>

#include "12_skin/sums.h"

namespace lightwalk {

void PictureBlur::ensure(Device& device, glm::uvec2 size) {
    for (const auto& [image, name] : {std::pair{&light, "skin light"}, {&after, "skin after"}, {&half_, "skin half"}})
        image->ensure(device, {.name = name, .size = size});
}

void PictureBlur::record(Frame& frame, const View& view, Canvas& canvas) {
    constexpr int side = 8;
    if (!kernel_) kernel_ = frame.gpu.upload("skin line", line_kernel(side));
    ScreenBlur blur{
        .direction = {1, 0}, .taps = 2 * side + 1, .pixels_at_1m = 1.0f / view.pixel_rad(), .edge_mm = 5.0f};
    const ImageView hdr = canvas.color(frame);
    frame.compute("skin separable", {.reads = {light, half_, after, hdr}, .writes = {light, half_, hdr}},
                  [&](Compute& pass) {
                      pass.use(line_).set("from", light, linear_clamp).set("into", half_).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(view.size).wait();
                      blur.direction = {0, 1};
                      pass.use(line_).set("from", half_, linear_clamp).set("into", light).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(view.size).wait();
                      pass.use(add_).set("light", light, nearest_clamp).set("after", after, nearest_clamp);
                      pass.set("hdr", hdr).dispatch_threads(view.size);
                  });
}

}  // namespace lightwalk
