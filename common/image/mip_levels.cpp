#include "common/image/mip_levels.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/gpu/image.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

std::vector<float> floats_of_all_halves() {
    std::vector<float> values(size_t{1} << 16);
    for (size_t half = 0; half < values.size(); ++half) values[half] = glm::unpackHalf1x16(static_cast<uint16_t>(half));
    return values;
}

// Nearest half float, ties to even, for finite values in range; six times as fast as glm's.
uint16_t half_of(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value), sign = bits >> 16 & 0x8000u;
    uint32_t size = bits & 0x7fffffffu;
    if (size < 0x38800000u)  // below 2^-14: adding 0.5 rounds to the spacing of denormal halves
        size = std::bit_cast<uint32_t>(std::bit_cast<float>(size) + 0.5f) - std::bit_cast<uint32_t>(0.5f);
    else
        size = (size + 0xfffu + (size >> 13 & 1u) - 0x38000000u) >> 13;
    return static_cast<uint16_t>(sign | size);
}

template <class Code>
Code mean_of_codes(const std::array<Code, 4>& four) {
    return static_cast<Code>((uint32_t(four[0]) + four[1] + four[2] + four[3] + 2) / 4);
}

uint16_t mean_of_halves(const std::array<uint16_t, 4>& four) {
    static const std::vector<float> floats = floats_of_all_halves();
    return half_of(0.25f * (floats[four[0]] + floats[four[1]] + floats[four[2]] + floats[four[3]]));
}

template <class Channel, class Mean>
void append_halved(std::span<const std::byte> from, glm::uvec2 size, const Mean& mean, std::vector<std::byte>& to) {
    const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
    const size_t row = 4 * size_t(size.x), right = size.x > 1 ? 4 : 0, below = size.y > 1 ? row : 0;
    std::vector<Channel> in(from.size() / sizeof(Channel)), out(4 * size_t(half.x) * half.y);
    std::memcpy(in.data(), from.data(), from.size());
    Channel* next = out.data();
    for (uint32_t y = 0; y < half.y; ++y)
        for (uint32_t x = 0; x < half.x; ++x)
            for (uint32_t channel = 0; channel < 4; ++channel) {
                const Channel* const at = in.data() + 2 * y * row + 8 * size_t(x) + channel;
                *next++ = mean({at[0], at[right], at[below], at[below + right]});
            }
    const auto bytes = std::as_bytes(std::span(out));
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void append_halved(VkFormat format, std::span<const std::byte> from, glm::uvec2 size, std::vector<std::byte>& to) {
    switch (format) {
        case VK_FORMAT_R8G8B8A8_UNORM:
            return append_halved<uint8_t>(from, size, mean_of_codes<uint8_t>, to);
        case VK_FORMAT_R16G16B16A16_UNORM:
            return append_halved<uint16_t>(from, size, mean_of_codes<uint16_t>, to);
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return append_halved<uint16_t>(from, size, mean_of_halves, to);
        default:
            throw Failure("no mip levels are made of {}", name_of(format));
    }
}

}  // namespace

std::vector<std::vector<std::byte>> mip_levels(VkFormat format, glm::uvec2 size, std::span<const std::byte> texels,
                                               uint32_t layers) {
    std::vector<std::vector<std::byte>> levels{{texels.begin(), texels.end()}};
    while (size != glm::uvec2(1)) {
        const std::span<const std::byte> from(levels.back());
        const size_t layer_bytes = from.size() / layers;
        std::vector<std::byte> to;
        to.reserve(from.size() / 2);
        for (uint32_t layer = 0; layer < layers; ++layer)
            append_halved(format, from.subspan(layer * layer_bytes, layer_bytes), size, to);
        levels.push_back(std::move(to));
        size = glm::max(size / 2u, glm::uvec2(1));
    }
    return levels;
}

std::vector<std::byte> linear_halves(std::span<const std::byte> codes) {
    std::array<uint16_t, 256> of_color, of_alpha;
    for (size_t code = 0; code < 256; ++code) {
        of_color[code] = half_of(srgb_to_linear(static_cast<uint8_t>(code)));
        of_alpha[code] = half_of(static_cast<float>(code) / 255.0f);
    }
    std::vector<uint16_t> halves(codes.size());
    for (size_t i = 0; i < codes.size(); ++i)
        halves[i] = (i % 4 == 3 ? of_alpha : of_color)[std::to_integer<size_t>(codes[i])];
    const auto bytes = std::as_bytes(std::span(halves));
    return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> srgb_codes(std::span<const std::byte> halves) {
    std::vector<std::byte> codes;
    codes.reserve(halves.size() / 2);
    for (size_t at = 0; at < halves.size(); at += 2) {
        uint16_t half = 0;
        std::memcpy(&half, &halves[at], 2);
        const float value = glm::unpackHalf1x16(half);
        codes.push_back(std::byte(std::lround(255.0f * (at % 8 == 6 ? value : linear_to_srgb(value)))));
    }
    return codes;
}

}  // namespace lightwalk
