#include "13_mlaa/four_samples.h"

#include "01_obj/camera_view.h"

namespace lightwalk {

void FourSamples::multisample(Frame& frame, Canvas& canvas) {
    Device& device = frame.gpu.device;
    color_.ensure(device, {.name = "four colours", .size = canvas.size(), .samples = 4});
    depth_.ensure(device, {.name = "four depths", .format = VK_FORMAT_D32_SFLOAT, .size = canvas.size(), .samples = 4});
    canvas.multisampled(color_, depth_);
}

void FourSamples::supersample(Frame& frame, const View& view, const std::function<void(const View&)>& draw) {
    const glm::vec2 places[] = {{-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};
    for (int i = 0; i < 4; ++i) {
        Crop crop = view.crop;
        crop.shift += places[i];
        View shifted = view_of(view.camera, view.size, crop);
        shifted.id = view.id;
        draw(shifted);
        frame.compute("add sample", {.reads = {frame.hdr, sum_}, .writes = {frame.hdr, sum_}}, [&](Compute& pass) {
            pass.use(add_).set("sample_index", i).set("hdr", frame.hdr).set("sum", sum_).dispatch_threads(view.size);
        });
    }
}

}  // namespace lightwalk
