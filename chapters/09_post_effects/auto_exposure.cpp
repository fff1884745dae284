#include "09_post_effects/auto_exposure.h"

#include <cmath>

#include "09_post_effects/adapt_now.h"

namespace lightwalk {

// [record]
void AutoExposure::record(Frame& frame, const Image& hdr) {
    if (!bins_) bins_ = Buffer(frame.gpu.device, {.name = path() + " bins", .bytes = 256 * sizeof(uint32_t)});
    const float passed_s = frame.time_s - std::exchange(last_s_, frame.time_s);
    const bool follows = stops_.valid() && passed_s > 0.0f && adapt_s > 0.0f;
    const Image &before = stops_.before(), &now = stops_.now();
    frame.compute(
        "histogram", {.reads = {hdr, bins_, before}, .writes = {bins_, now}, .with = {*this}}, [&](Compute& pass) {
            pass.use(clear_).set("words", bins_).dispatch_threads({256u, 1u}).wait();
            pass.use(count_).set("picture_bins", bins_).set("hdr", hdr, nearest_clamp);
            pass.dispatch_threads(hdr.desc.size).wait();
            pass.use(adapt_).set("picture_bins", bins_).set("before", before, nearest_clamp);
            pass.set("adapt_now",
                     AdaptNow{.share = follows ? 1.0f - std::exp(-passed_s / adapt_s) : 1.0f, .valid = stops_.valid()});
            pass.set("now", now).dispatch({1, 1, 1});
        });
    shown_ = &now;
}
// [/record]

}  // namespace lightwalk
