// Point-spread error of a blur: its image of one bright pixel against the reference.
#pragma once
#include <fmt/core.h>

#include <cmath>
#include <map>

#include "08_bloom/bloom.h"
#include "common/app/render.h"

namespace lightwalk {

/// The root of the sum of (found - exact)² over that of exact²; linear light, green. Of one size.
inline double relative_l2(const ImageRgb& found, const ImageRgb& exact) {
    double off = 0, all = 0;
    for (size_t i = 0; i < exact.pixels.size(); ++i) {
        const double a = double(found.pixels[i].g), b = double(exact.pixels[i].g);
        off += (a - b) * (a - b);
        all += b * b;
    }
    return all > 0 ? std::sqrt(off / all) : std::sqrt(off);
}

class PointSpread {
  public:
    /// Draws the bright pixel into frame.hdr, so far to the right of the middle.
    void draw_spot(Frame& frame, float x_px) const {
        frame.compute("spot", {.writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(spot_).set("spot_x", x_px).set("result", frame.hdr).dispatch_threads(frame.size);
        });
    }

    /// How far the chapter's picture is from that of the method `exact`: the root of the sum of squared differences
    /// over that of the exact squares, 0 to about 1. Sets bloom.method, and leaves it to the caller to put it back.
    double error(Chapter& chapter, Bloom& bloom, Gpu& gpu, glm::uvec2 size) {
        if (bloom.method.is("none")) return 1;  // nothing of it is spread
        const ImageRgb found = render_linear(chapter, gpu, size);
        ImageRgb& exact = exact_[fmt::format("{}x{} {} {} {}", size.x, size.y, bloom.sigma_px.text(),
                                             bloom.shape.text(), bloom.border.text())];
        if (exact.pixels.empty()) {
            bloom.method.set("exact");
            exact = render_linear(chapter, gpu, size);
        }
        return relative_l2(found, exact);
    }

  private:
    Pipeline spot_ = compute({.shader = "08_bloom/spot.comp"});
    std::map<std::string, ImageRgb> exact_;  ///< key of the reference
};

}  // namespace lightwalk
