// Mip levels of colour textures against the formula in double precision.
#include <cmath>
#include <random>

#include "catch.h"
#include "common/scene/color_levels.h"

using namespace lightwalk;

namespace {

double decoded(std::byte code) {
    const double c = std::to_integer<int>(code) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<std::byte> noise(size_t texels) {
    std::mt19937 random(7);
    std::vector<std::byte> codes;
    for (size_t i = 0; i < 4 * texels; ++i) codes.push_back(std::byte(random() & 255));
    return codes;
}

}  // namespace

TEST_CASE("color_levels: each texel is the nearest code to the mean in linear light, alpha's to the plain mean") {
    for (const glm::uvec2 first : {glm::uvec2(64, 32), glm::uvec2(7, 5), glm::uvec2(1, 9)}) {
        glm::uvec2 size = first;
        const auto levels = color_levels(size, noise(size_t(size.x) * size.y));
        REQUIRE(levels[0] == noise(size_t(size.x) * size.y));
        double worst = 0.0, worst_alpha = 0.0;
        for (size_t level = 1; level < levels.size(); ++level) {
            const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
            REQUIRE(levels[level].size() == size_t(4) * half.x * half.y);
            for (uint32_t i = 0; i < half.x * half.y * 4; ++i) {
                const uint32_t channel = i % 4, x = i / 4 % half.x, y = i / 4 / half.x;
                double sum = 0.0;
                for (const glm::uvec2 d : {glm::uvec2(0, 0), glm::uvec2(1, 0), glm::uvec2(0, 1), glm::uvec2(1, 1)}) {
                    const glm::uvec2 at = glm::min(glm::uvec2(2 * x, 2 * y) + d, size - 1u);
                    const std::byte code = levels[level - 1][4 * (size_t(at.y) * size.x + at.x) + channel];
                    sum += channel == 3 ? std::to_integer<int>(code) / 255.0 : decoded(code);
                }
                const double expected = 255.0 * (channel == 3 ? 0.25 * sum : encoded(0.25 * sum));
                double& most = channel == 3 ? worst_alpha : worst;
                most = std::max(most, std::abs(std::to_integer<int>(levels[level][i]) - expected));
            }
            size = half;
        }
        CHECK(size == glm::uvec2(1));
        CHECK(worst_alpha <= 0.5001);
        CHECK(worst <= 0.5001);
    }
}

TEST_CASE("color_levels: one colour stays what it is on every level") {
    for (int code = 0; code < 256; ++code)
        for (const auto& level : color_levels({4, 4}, std::vector<std::byte>(64, std::byte(code))))
            for (const std::byte each : level) REQUIRE(std::to_integer<int>(each) == code);
}
