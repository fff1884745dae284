#include "10_atmosphere/cloud_layer.h"

#include <cmath>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {

void CloudLayer::update(Frame& frame) {
    if (method.is("none") || std::exchange(has_noise_, true)) return;
    noise_.ensure(
        frame.gpu.device,
        {.name = path() + " noise", .format = VK_FORMAT_R16_SFLOAT, .size = glm::uvec2(64), .depth = 64, .kept = true});
    frame.compute("cloud noise", {.writes = {noise_}},
                  [&](Compute& pass) { pass.use(make_noise_).set("result", noise_).dispatch(glm::uvec3(16, 16, 16)); });
}

// [draw]
void CloudLayer::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (method.is("none")) return;
    const Image *transmittance = atmosphere_.table("transmittance"), *multiple = atmosphere_.table("multiple");
    if (!transmittance) throw InputError("{}: clouds need the air's tables; set atmosphere.method to tables", path());
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    // The drift in double precision: after hours a float would move the clouds in steps.
    const double moved_m = std::fmod(static_cast<double>(drift_m_s) * static_cast<double>(frame.time_s), 1e7);
    frame.compute("clouds",
                  {.reads = {depth, hdr, noise_, *transmittance, *multiple},
                   .writes = {hdr},
                   .with = {atmosphere_, planet_, *this}},
                  [&](Compute& pass) {
                      pass.use(march_).set("result", hdr).set("depth", depth, nearest_clamp);
                      pass.set("cloud_noise", noise_, Sampler{.wrap = Wrap::repeat});
                      pass.set("air_transmittance", *transmittance, linear_clamp);
                      pass.set_if_present("air_multiple", *multiple, linear_clamp);
                      pass.set("rays", view_rays(view)).set("moved_m", static_cast<float>(moved_m));
                      pass.set("jitter", static_cast<float>(frame.samples.index));
                      pass.dispatch_threads(view.size);
                  });
}
// [/draw]

}  // namespace lightwalk
