#include "13_mlaa/four_samples.h"

namespace lightwalk {

RasterTargets FourSamples::multisampled(Frame& frame, const Image& into, const glm::vec4& background) {
    const glm::uvec2 size = into.desc.size;
    if (!color_ || color_.desc.size != size) {
        color_ = Image(frame.gpu.device, {.name = "four colours", .size = size, .samples = 4});
        depth_ = Image(frame.gpu.device,
                       {.name = "four depths", .format = VK_FORMAT_D32_SFLOAT, .size = size, .samples = 4});
    }
    return {.color = {resolve(clear(color_, background), into)}, .depth = depth_};
}

void FourSamples::supersample(Frame& frame, const std::function<void()>& draw) {
    const glm::vec2 places[] = {{-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};
    const glm::vec2 shift = frame.crop.shift;
    for (int i = 0; i < 4; ++i) {
        frame.crop.shift = shift + places[i];
        draw();
        frame.compute("add sample", {.reads = {frame.hdr, sum_}, .writes = {frame.hdr, sum_}}, [&](Compute& pass) {
            pass.use(add_).set("sample_index", i).set("hdr", frame.hdr).set("sum", sum_).dispatch_threads(frame.size);
        });
    }
    frame.crop.shift = shift;
}

}  // namespace lightwalk
