// Shared by the tests of the effects: a synthetic picture, and a module's result.
#pragma once
#include <cmath>

#include "../common/module_fixture.h"
#include "09_post_effects/post.h"
#include "09_post_effects/truth.h"

namespace lightwalk {

struct OnPost : OnModules {
    Post post{owner, "post"};
    Image hdr;

    OnPost() { switch_off(); }

    void switch_off() {
        for (KnobBase* effect : post.effects()) effect->set("off");
    }

    /// The module's result for a picture of value(x, y), a vec3 or a number.
    template <class Value>
    ImageRgb shown(glm::uvec2 size, const Value& value, float time_s = 0) {
        const auto record = [&] {
            frame.crop.whole = size;
            post.record(frame, hdr);
        };
        filter_frame(hdr, size, half_texels(size, value, 1.0f), record, time_s);
        return read_linear(gpu, hdr);
    }
};

/// Even light.
inline auto all_of(glm::vec3 color) {
    return [=](int, int) { return color; };
}

/// Colours from black to 16, with nothing regular in them.
inline glm::vec3 motley(int x, int y) {
    uint32_t n = uint32_t(x) * 73856093u ^ uint32_t(y) * 19349663u;
    n = (n ^ n >> 13) * 0x5bd1e995u;
    const glm::vec3 c(float(n & 255), float(n >> 8 & 255), float(n >> 16 & 255));
    return c * c * (16.0f / 65025.0f);
}

inline double largest_difference(const ImageRgb& a, const ImageRgb& b) {
    double most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::fabs(double(a.pixels[i][c]) - double(b.pixels[i][c])));
    return most;
}

inline bool is_finite(const ImageRgb& picture) {
    for (const glm::vec3& pixel : picture.pixels)
        if (!std::isfinite(pixel.r) || !std::isfinite(pixel.g) || !std::isfinite(pixel.b)) return false;
    return true;
}

inline glm::dvec3 mean(const ImageRgb& picture) {
    glm::dvec3 sum(0);
    for (const glm::vec3& pixel : picture.pixels) sum += glm::dvec3(pixel) / double(picture.pixels.size());
    return sum;
}

/// The same bits.
inline bool identical(const ImageRgb& a, const ImageRgb& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(glm::vec3)) == 0;
}

}  // namespace lightwalk
