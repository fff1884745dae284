#include "08_bloom/point_spread.h"

#include <fmt/core.h>

#include <cmath>

#include "common/app/render.h"

namespace lightwalk {

double relative_l2(const ImageRgb& found, const ImageRgb& exact) {
    double off = 0, all = 0;
    for (size_t i = 0; i < exact.pixels.size(); ++i) {
        const double a = double(found.pixels[i].g), b = double(exact.pixels[i].g);
        off += (a - b) * (a - b);
        all += b * b;
    }
    return all > 0 ? std::sqrt(off / all) : std::sqrt(off);
}

void PointSpread::draw_spot(Frame& frame, float x_px) const {
    frame.compute("spot", {.writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(spot_).set("spot_x", x_px).set("result", frame.hdr).dispatch_threads(frame.size);
    });
}

double PointSpread::error(Chapter& chapter, Bloom& bloom, Gpu& gpu, glm::uvec2 size) {
    if (bloom.method.is("none")) return 1;  // nothing of it is spread
    const ImageRgb found = render_linear(chapter, gpu, size);
    ImageRgb& exact = exact_[fmt::format("{}x{} {} {} {}", size.x, size.y, bloom.sigma_px.text(), bloom.shape.text(),
                                         bloom.border.text())];
    if (exact.pixels.empty()) {
        bloom.method.set("exact");
        exact = render_linear(chapter, gpu, size);
    }
    return relative_l2(found, exact);
}

}  // namespace lightwalk
