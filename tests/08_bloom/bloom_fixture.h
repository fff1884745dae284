// What tests of the bloom share: a picture from numbers, and what the module makes of it.
#pragma once
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "../common/gpu_fixture.h"
#include "08_bloom/bloom.h"
#include "08_bloom/point_spread.h"
#include "common/app/read_picture.h"

namespace lightwalk {

inline const std::vector<std::string> blurs{"pyramid", "dual_kawase", "three_pass_7tap", "shared",
                                            "paired",  "separable",   "pingpong",        "window"};

struct OnBloom {
    struct Owner : Module {
    } owner;
    Bloom bloom{owner, "bloom"};
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    Image hdr;

    OnBloom() {
        bloom.cut.set("none");
        bloom.shape.set("gaussian");
        bloom.strength.value = 0.5f;
    }
    ~OnBloom() { CHECK_NOTHROW(gpu.device.check_validation()); }

    /// Records the bloom of a picture of value(x, y); hdr then has the picture with it.
    template <class Value>
    void record(glm::uvec2 size, const Value& value) {
        std::vector<uint64_t> texels;
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x)
                texels.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(value(int(x), int(y))), 0.25f)));
        if (!hdr || hdr.desc.size != size) hdr = Image(gpu.device, {.name = "picture", .size = size});
        frame.begin({4, 4}, 0);
        frame.upload("picture", hdr, std::as_bytes(std::span(texels)));
        bloom.record(frame, hdr);
        frame.end();
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
            weight += w, mean += w * x, square += w * x * x;
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
