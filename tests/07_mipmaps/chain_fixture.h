// Shared by the tests of levels: an image from numbers, its levels by a method.
#pragma once
#include <algorithm>

#include "../common/module_fixture.h"
#include "07_mipmaps/texels.h"
#include "07_mipmaps/truth.h"

namespace lightwalk {

struct OnChain : OnModules {
    MipChain chain{owner, "mips"};

    /// `layers` images in one, each from value(layer, x, y).
    template <class Value>
    Image image(glm::uvec2 size, VkFormat format, const Value& value, uint32_t layers = 1, bool cube = false) {
        Image made(gpu.device, {.name = "test",
                                .format = format,
                                .size = size,
                                .mips = full_mip_count(size),
                                .layers = layers,
                                .cube = cube,
                                .kept = true});
        std::vector<std::byte> all;
        for (uint32_t layer = 0; layer < layers; ++layer) {
            truth::Texels texels{size, {}};
            for (uint32_t y = 0; y < size.y; ++y)
                for (uint32_t x = 0; x < size.x; ++x) texels.values.push_back(value(layer, x, y));
            const auto bytes = to_bytes(texels, format);
            all.insert(all.end(), bytes.begin(), bytes.end());
        }
        Frame filling(gpu);
        filling.begin({4, 4}, 0);
        filling.upload("first level", ImageView(made).mip(0), all);
        filling.end();
        return made;
    }

    void fill(const ImageView& image, const std::string& method, Content content = Content::each, float cutoff = 0.5f) {
        chain.method.set(method);
        Frame own(gpu);
        own.begin({4, 4}, 0);
        chain.record(own, image, content, cutoff);
        own.end();
    }

    truth::Texels level(const ImageView& image, uint32_t m) { return read_texels(gpu, image.mip(m)); }
    glm::dvec4 last(const ImageView& image) { return level(image, image.mips - 1).values[0]; }

    /// The share of a level's texels with an alpha above the cutoff.
    double covered(const ImageView& image, uint32_t m, double cutoff) {
        const truth::Texels found = level(image, m);
        const auto count = std::ranges::count_if(found.values, [&](glm::dvec4 texel) { return texel.a >= cutoff; });
        return static_cast<double>(count) / static_cast<double>(found.values.size());
    }

    /// Of each level, from the second on.
    std::vector<double> errors(const ImageView& image, Content content = Content::linear) {
        return level_errors(gpu, image, content);
    }
};

/// Sizes that halve badly: lines, primes, one beside a tile of 64.
inline const std::vector<glm::uvec2> odd_sizes{{1, 1},   {1, 7},    {1, 300}, {1023, 1}, {3, 5},     {64, 64},
                                               {65, 63}, {129, 67}, {200, 1}, {5, 130},  {256, 256}, {500, 333}};

/// Numbers from 0 to 1 for OnChain::image().
inline glm::dvec4 noise(uint32_t layer, uint32_t x, uint32_t y) {
    uint32_t n = (x * 73856093u) ^ (y * 19349663u) ^ (layer * 83492791u);
    n = (n ^ n >> 13) * 0x5bd1e995u;
    n ^= n >> 15;
    return {double(n & 255) / 255, double(n >> 8 & 255) / 255, double(n >> 16 & 255) / 255, 1};
}

inline const std::vector<std::string> filters{"blit", "box", "single_pass", "polyphase", "kaiser"};

}  // namespace lightwalk
