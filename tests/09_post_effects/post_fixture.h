// What tests of the effects share: a picture from numbers, and what a module makes of it.
#pragma once
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "../common/gpu_fixture.h"
#include "09_post_effects/post.h"
#include "09_post_effects/truth.h"
#include "common/app/read_picture.h"

namespace lightwalk {

struct OnPost {
    struct Owner : Module {
    } owner;
    Post post{owner, "post"};
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    Image hdr;

    OnPost() { switch_off(); }
    ~OnPost() { CHECK_NOTHROW(gpu.device.check_validation()); }

    void switch_off() {
        for (KnobBase* effect : post.effects()) effect->set("off");
    }

    /// What the module makes of a picture of value(x, y), a vec3 or a number.
    template <class Value>
    ImageRgb shown(glm::uvec2 size, const Value& value, float time_s = 0) {
        std::vector<uint64_t> texels;
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x)
                texels.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(value(int(x), int(y))), 1.0f)));
        if (!hdr || hdr.desc.size != size) hdr = Image(gpu.device, {.name = "picture", .size = size});
        owner_begin(time_s);
        frame.upload("picture", hdr, std::as_bytes(std::span(texels)));
        frame.crop.whole = size;
        post.record(frame, hdr);
        frame.end();
        return read_linear(gpu, hdr);
    }

    void owner_begin(float time_s) {
        post.begin_frame(gpu, {4, 4});
        frame.begin({4, 4}, time_s);
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
