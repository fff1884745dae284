// Mip levels against means in double precision.
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <random>

#include "catch.h"
#include "common/base/error.h"
#include "common/image/mip_levels.h"

using namespace lightwalk;

namespace {

std::vector<std::byte> noise(size_t count) {
    std::mt19937 random(7);
    std::vector<std::byte> bytes;
    for (size_t i = 0; i < count; ++i) bytes.push_back(std::byte(random() & 255));
    return bytes;
}

double number(VkFormat format, std::span<const std::byte> texels, size_t channel) {
    if (format == VK_FORMAT_R8G8B8A8_UNORM) return std::to_integer<int>(texels[channel]);
    uint16_t word = 0;
    std::memcpy(&word, &texels[2 * channel], 2);
    return format == VK_FORMAT_R16G16B16A16_UNORM ? word : double(glm::unpackHalf1x16(word));
}

// IEC 61966-2-1.
double decoded(double code) { return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4); }

}  // namespace

TEST_CASE("mip_levels: each texel of each layer is nearest to the mean of its four, for every format and odd sizes") {
    for (const VkFormat format :
         {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R16G16B16A16_UNORM, VK_FORMAT_R16G16B16A16_SFLOAT})
        for (const glm::uvec2 first : {glm::uvec2(64, 32), glm::uvec2(7, 5), glm::uvec2(1, 9)}) {
            glm::uvec2 size = first;
            constexpr uint32_t layers = 2;
            const auto codes =
                noise(size_t(4) * size.x * size.y * layers * (format == VK_FORMAT_R16G16B16A16_UNORM ? 2 : 1));
            const auto levels = mip_levels(
                format, size, format == VK_FORMAT_R16G16B16A16_SFLOAT ? linear_halves(codes) : codes, layers);
            double worst = 0.0;
            for (size_t level = 1; level < levels.size(); ++level) {
                const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
                for (uint32_t i = 0; i < layers * half.x * half.y * 4; ++i) {
                    const uint32_t channel = i % 4, x = i / 4 % half.x, y = i / 4 / half.x % half.y,
                                   layer = i / 4 / half.x / half.y;
                    double mean = 0.0;
                    for (const glm::uvec2 d :
                         {glm::uvec2(0, 0), glm::uvec2(1, 0), glm::uvec2(0, 1), glm::uvec2(1, 1)}) {
                        const glm::uvec2 at = glm::min(glm::uvec2(2 * x, 2 * y) + d, size - 1u);
                        const size_t texel = (size_t(layer) * size.y + at.y) * size.x + at.x;
                        mean += 0.25 * number(format, levels[level - 1], 4 * texel + channel);
                    }
                    // Steps of 1 for codes; of a half, 2^-11 of its value, or 2^-25 near zero.
                    const double step =
                        format == VK_FORMAT_R16G16B16A16_SFLOAT ? std::max(0x1p-10 * mean, 0x1p-24) : 1.0;
                    worst = std::max(worst, std::abs(number(format, levels[level], i) - mean) / step);
                }
                size = half;
            }
            CHECK(size == glm::uvec2(1));
            CHECK(worst <= 0.5001);
        }
    CHECK_THROWS_AS(mip_levels(VK_FORMAT_R32_SFLOAT, {2, 2}, noise(16)), Failure);
}

TEST_CASE("linear_halves: every code is within half a step of a half of the sRGB curve, alpha of a straight line") {
    for (int code = 0; code < 256; ++code) {
        const auto halves = linear_halves(std::vector<std::byte>(4, std::byte(code)));
        for (size_t channel = 0; channel < 4; ++channel) {
            const double right = channel == 3 ? code / 255.0 : decoded(code / 255.0);
            const double got = number(VK_FORMAT_R16G16B16A16_SFLOAT, halves, channel);
            CHECK(std::abs(got - right) <= 0.5001 * std::max(0x1p-10 * right, 0x1p-24));
        }
        CHECK(srgb_codes(halves) == std::vector<std::byte>(4, std::byte(code)));
    }
}
