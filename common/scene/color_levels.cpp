#include "common/scene/color_levels.h"

#include <algorithm>
#include <array>

#include "common/image/image.h"

namespace lightwalk {
namespace {

/// What the codes 0, 1/2, 1, 3/2 ... 255 mean in linear light.
std::array<float, 511> linear_of_half_codes() {
    std::array<float, 511> values;
    for (size_t i = 0; i < values.size(); ++i) values[i] = srgb_to_linear(static_cast<float>(i) / 510.0f);
    return values;
}

}  // namespace

std::vector<std::vector<std::byte>> color_levels(glm::uvec2 size, std::span<const std::byte> texels) {
    static const std::array<float, 511> linear = linear_of_half_codes();
    static const std::array<float, 255> between = [] {  // from where on a value is nearer to the next code
        std::array<float, 255> values;
        for (size_t i = 0; i < values.size(); ++i) values[i] = linear[2 * i + 1];
        return values;
    }();
    std::vector<std::vector<std::byte>> levels{{texels.begin(), texels.end()}};
    while (size != glm::uvec2(1)) {
        const std::vector<std::byte>& from = levels.back();
        const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
        std::vector<std::byte> to;
        to.reserve(size_t(half.x) * half.y * 4);
        for (uint32_t y = 0; y < half.y; ++y)
            for (uint32_t x = 0; x < half.x; ++x)
                for (size_t channel = 0; channel < 4; ++channel) {
                    const auto code = [&](uint32_t dx, uint32_t dy) {
                        const size_t row = std::min(2 * y + dy, size.y - 1), column = std::min(2 * x + dx, size.x - 1);
                        return std::to_integer<size_t>(from[4 * (row * size.x + column) + channel]);
                    };
                    const std::array<size_t, 4> four{code(0, 0), code(1, 0), code(0, 1), code(1, 1)};
                    if (channel == 3) {
                        to.push_back(std::byte((four[0] + four[1] + four[2] + four[3] + 2) / 4));
                        continue;
                    }
                    float sum = 0.0f;
                    for (const size_t each : four) sum += linear[2 * each];
                    const auto nearest = std::upper_bound(between.begin(), between.end(), 0.25f * sum);
                    to.push_back(std::byte(nearest - between.begin()));
                }
        levels.push_back(std::move(to));
        size = half;
    }
    return levels;
}

}  // namespace lightwalk
