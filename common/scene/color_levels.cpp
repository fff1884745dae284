#include "common/scene/color_levels.h"

#include <array>

#include "common/image/image.h"

namespace lightwalk {
namespace {

/// Linear light of the codes 0, 1/2, 1, 3/2 ... 255.
std::array<float, 511> linear_of_half_codes() {
    std::array<float, 511> values;
    for (size_t i = 0; i < values.size(); ++i) values[i] = srgb_to_linear(static_cast<float>(i) / 510.0f);
    return values;
}

// For each step of linear light, the first code that a value in it can be nearest to: a search over all codes took most of
// the time in which a texture is loaded. A step is less than a code wide, for the darkest, too.
constexpr float steps = 4096.0f;
std::vector<uint8_t> first_codes(const std::array<float, 511>& linear) {
    std::vector<uint8_t> first;
    for (size_t i = 0, code = 0; i <= static_cast<size_t>(steps); ++i) {
        while (code < 255 && linear[2 * code + 1] <= static_cast<float>(i) / steps) ++code;
        first.push_back(static_cast<uint8_t>(code));
    }
    return first;
}

}  // namespace

std::vector<std::vector<std::byte>> color_levels(glm::uvec2 size, std::span<const std::byte> texels) {
    static const std::array<float, 511> linear = linear_of_half_codes();
    static const std::vector<uint8_t> first = first_codes(linear);
    // From half a code below it on, a value is nearest to that code.
    const auto nearest_code = [&](float value) {
        size_t code = first[static_cast<size_t>(value * steps)];
        while (code < 255 && linear[2 * code + 1] <= value) ++code;
        return std::byte(code);
    };
    std::vector<std::vector<std::byte>> levels{{texels.begin(), texels.end()}};
    while (size != glm::uvec2(1)) {
        const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
        const size_t row = 4 * size_t(size.x), right = size.x > 1 ? 4 : 0, below = size.y > 1 ? row : 0;
        std::vector<std::byte> to(size_t(half.x) * half.y * 4);
        std::byte* out = to.data();
        for (uint32_t y = 0; y < half.y; ++y)
            for (uint32_t x = 0; x < half.x; ++x)
                for (size_t channel = 0; channel < 4; ++channel, ++out) {
                    const std::byte* const at = levels.back().data() + 2 * y * row + 8 * size_t(x) + channel;
                    const auto code = [&](size_t offset) { return std::to_integer<size_t>(at[offset]); };
                    const std::array<size_t, 4> four{code(0), code(right), code(below), code(below + right)};
                    if (channel == 3) {
                        *out = std::byte((four[0] + four[1] + four[2] + four[3] + 2) / 4);
                        continue;
                    }
                    float sum = 0.0f;
                    for (const size_t each : four) sum += linear[2 * each];
                    *out = nearest_code(0.25f * sum);
                }
        levels.push_back(std::move(to));
        size = half;
    }
    return levels;
}

}  // namespace lightwalk
