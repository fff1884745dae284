// Shared by the tests of the bloom: a synthetic picture, and the module's result.
#pragma once
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "../common/module_fixture.h"
#include "08_bloom/bloom.h"
#include "08_bloom/point_spread.h"

namespace lightwalk {

inline const std::vector<std::string> blurs{"pyramid", "dual_kawase", "three_pass_7tap", "shared",
                                            "paired",  "separable",   "pingpong",        "window"};

struct OnBloom : OnModules {
    Bloom bloom{owner, "bloom"};
    Image hdr;

    OnBloom() {
        bloom.cut.set("none");
        bloom.shape.set("gaussian");
        bloom.strength.value = 0.5f;
    }

    /// Records the bloom of a picture of value(x, y); hdr then has the picture with it.
    template <class Value>
    void record(glm::uvec2 size, const Value& value) {
        filter_frame(hdr, size, half_texels(size, value, 0.25f), [&] { bloom.record(frame, hdr); });
    }

    ImageRgb spread() { return read_linear(gpu, bloom.spread()); }
    ImageRgb picture() { return read_linear(gpu, hdr); }

    template <class Value>
    ImageRgb spread_of(const std::string& method, float sigma_px, glm::uvec2 size, const Value& value) {
        bloom.method.set(method);
        bloom.sigma_px.value = sigma_px;
        record(size, value);
        return spread();
    }
};

inline double sum(const ImageRgb& picture) {
    double all = 0;
    for (const glm::vec3& pixel : picture.pixels) all += double(pixel.g);
    return all;
}

/// Along x, in square pixels, about the picture's own mean.
inline double variance(const ImageRgb& picture) {
    double weight = 0, mean = 0, square = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double w = double(picture.at(x, y).g);
            weight += w;
            mean += w * x;
            square += w * x * x;
        }
    return square / weight - (mean / weight) * (mean / weight);
}

inline bool is_finite(const ImageRgb& picture) {
    for (const glm::vec3& pixel : picture.pixels)
        if (!std::isfinite(pixel.r) || !std::isfinite(pixel.g) || !std::isfinite(pixel.b)) return false;
    return true;
}

/// A pixel's worth of light at (x, y), which may lie across four pixels.
inline auto spot_at(double x, double y, double light = 1000) {
    return [=](int i, int j) {
        return float(light * std::max(0.0, 1 - std::fabs(i - x)) * std::max(0.0, 1 - std::fabs(j - y)));
    };
}

}  // namespace lightwalk
