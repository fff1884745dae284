#include "08_bloom/point_spread.h"

#include <fmt/core.h>

#include <cmath>

#include "common/app/read_picture.h"
#include "common/app/render.h"

namespace lightwalk {

double relative_l2(const ImageRgb& found, const ImageRgb& exact) {
    double off = 0, all = 0;
    for (size_t i = 0; i < exact.pixels.size(); ++i) {
        const double a = double(found.pixels[i].g), b = double(exact.pixels[i].g);
        off += (a - b) * (a - b), all += b * b;
    }
    return all > 0 ? std::sqrt(off / all) : std::sqrt(off);
}

double PointSpread::error(Chapter& chapter, Bloom& bloom, Gpu& gpu, glm::uvec2 size) {
    const auto draw = [&] {
        Frame frame(gpu);
        render(chapter, frame, {size, 0.0f, 0, {}});
        return read_linear(gpu, frame.hdr);
    };
    if (bloom.method.is("none")) return 1;  // nothing of it is spread
    const ImageRgb found = draw();
    ImageRgb& exact = exact_[fmt::format("{}x{} {} {} {}", size.x, size.y, bloom.sigma_px.text(), bloom.shape.text(),
                                         bloom.border.text())];
    if (exact.pixels.empty()) {
        bloom.method.set("exact");
        exact = draw();
    }
    return relative_l2(found, exact);
}

}  // namespace lightwalk
