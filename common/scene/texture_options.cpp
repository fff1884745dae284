#include "common/scene/texture_options.h"

#include <algorithm>
#include <cstring>

namespace lightwalk {
namespace {

constexpr float bump_texels = 4;

float number_at(const TexelImage& image, size_t i) {
    if (image.bits == 8) return static_cast<float>(std::to_integer<int>(image.bytes[i])) / 255.0f;
    uint16_t value;
    std::memcpy(&value, &image.bytes[2 * i], sizeof value);
    return static_cast<float>(value) / 65535.0f;
}

void set_number(TexelImage& image, size_t i, float number) {
    number = std::clamp(number, 0.0f, 1.0f);
    if (image.bits == 8) {
        image.bytes[i] = static_cast<std::byte>(std::lround(number * 255.0f));
        return;
    }
    const auto value = static_cast<uint16_t>(std::lround(number * 65535.0f));
    std::memcpy(&image.bytes[2 * i], &value, sizeof value);
}

size_t texel_count(const TexelImage& image) {
    return static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
}

TexelImage blank(int width, int height, int bits) {
    TexelImage image{.width = width, .height = height, .bits = bits, .channels = 3, .bytes = {}};
    image.bytes.assign(texel_count(image) * 4 * static_cast<size_t>(bits / 8), std::byte{255});
    return image;
}

float channel_of(const glm::vec4& texel, char channel) {
    switch (channel) {
        case 'r':
            return texel.r;
        case 'g':
            return texel.g;
        case 'b':
            return texel.b;
        case 'm':
            return texel.a;
        default:  // 'l' and 'z': images have no depth, so luminance
            return glm::dot(glm::vec3(texel), glm::vec3(0.2126f, 0.7152f, 0.0722f));
    }
}

glm::vec4 texel_at(const TexelImage& image, size_t i) {
    return {number_at(image, 4 * i), number_at(image, 4 * i + 1), number_at(image, 4 * i + 2),
            number_at(image, 4 * i + 3)};
}

// Normal maps are mostly blue, and red and green average 1/2.
bool holds_normals(const TexelImage& image) {
    glm::vec4 sum(0.0f);
    float colored = 0;
    for (size_t i = 0; i < texel_count(image); ++i) {
        const glm::vec4 t = texel_at(image, i);
        sum += t;
        colored += std::abs(t.b - t.r) + std::abs(t.b - t.g);
    }
    const float count = static_cast<float>(texel_count(image));
    const glm::vec4 mean = sum / count;
    return colored / count > 0.1f && mean.b > 0.6f && std::abs(mean.r - 0.5f) < 0.2f && std::abs(mean.g - 0.5f) < 0.2f;
}

}  // namespace

TexelImage with_options(TexelImage image, const TextureMap& map) {
    const bool maps_numbers = map.base_gain != glm::vec2(0, 1);
    if (!map.channel && !maps_numbers) return image;
    const char channel = map.channel == alpha_if_any ? (image.channels % 2 == 0 ? 'm' : 'l') : map.channel;
    for (size_t i = 0; i < texel_count(image); ++i) {
        glm::vec4 texel = texel_at(image, i);
        if (map.channel) texel = glm::vec4(glm::vec3(channel_of(texel, channel)), 1.0f);
        texel = glm::vec4(map.base_gain.x + map.base_gain.y * glm::vec3(texel), texel.a);
        for (int c = 0; c < 4; ++c) set_number(image, 4 * i + size_t(c), texel[c]);
    }
    if (map.channel) image.channels = 3;
    return image;
}

TexelImage normals_of(TexelImage heights, float multiplier) {
    if (holds_normals(heights)) return heights;
    const int w = heights.width, h = heights.height;
    TexelImage normals = blank(w, h, heights.bits);
    const auto height = [&](int x, int y) {
        const size_t at = static_cast<size_t>((y + h) % h) * static_cast<size_t>(w) + static_cast<size_t>((x + w) % w);
        return bump_texels * multiplier * number_at(heights, 4 * at);
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const float along_u = 0.5f * (height(x + 1, y) - height(x - 1, y));
            const float along_v = 0.5f * (height(x, y - 1) - height(x, y + 1));  // rows run downwards
            const glm::vec3 n = glm::normalize(glm::vec3(-along_u, -along_v, 1.0f));
            const size_t at = static_cast<size_t>(y) * static_cast<size_t>(w) + static_cast<size_t>(x);
            for (int c = 0; c < 3; ++c) set_number(normals, 4 * at + size_t(c), 0.5f + 0.5f * n[c]);
        }
    return normals;
}

TexelImage roughness_and_metalness(const TexelImage& roughness, const TexelImage& metalness) {
    TexelImage both = blank(std::max(roughness.width, metalness.width), std::max(roughness.height, metalness.height),
                            std::max(roughness.bits, metalness.bits));
    const auto put = [&](const TexelImage& from, size_t channel) {
        if (from.width == 0) return;
        for (int y = 0; y < both.height; ++y)
            for (int x = 0; x < both.width; ++x) {
                const int row = y * from.height / both.height, column = x * from.width / both.width;
                const size_t at = static_cast<size_t>(row) * size_t(from.width) + size_t(column);
                const size_t to = static_cast<size_t>(y) * size_t(both.width) + size_t(x);
                set_number(both, 4 * to + channel, number_at(from, 4 * at));
            }
    };
    put(roughness, 1);
    put(metalness, 2);
    return both;
}

}  // namespace lightwalk
