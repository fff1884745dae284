#include "common/scene/image_pool.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/image/image.h"
#include "common/image/mip_levels.h"
#include "common/scene/material.h"

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

// Applies -imfchan (channel replicated to RGB) and -mm (base + gain · value).
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

// Normal map of heights in which black to white is `multiplier` × 4 texels; normal maps are returned unchanged.
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

// Packs the red channels into green and blue, at the larger size; an empty image counts as white.
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

DecodedTexture linear_texels(const std::filesystem::path& file) {
    const ImageRgb image = read_image_linear(file);
    std::vector<uint16_t> halves;
    halves.reserve(4 * image.pixels.size());
    size_t not_numbers = 0;
    for (const glm::vec3& p : image.pixels)
        for (const float value : {p.r, p.g, p.b, 1.0f}) {
            halves.push_back(glm::packHalf1x16(std::clamp(value, -65504.0f, 65504.0f)));
            not_numbers += std::isnan(value);
        }
    if (not_numbers > 0) throw InputError("{}: {} of its values are NaN, expected numbers", file.string(), not_numbers);
    const glm::uvec2 size(image.width, image.height);
    constexpr VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
    return {.desc = {.format = format, .size = size},
            .levels = mip_levels(format, size, std::as_bytes(std::span(halves)))};
}

TexelImage read_map(const TextureMap& map, bool is_data) {
    return map.bytes ? read_texels(map.file, *map.bytes, is_data) : read_texels(map.file, is_data);
}

std::string key_of_map(const TextureMap& map) {
    std::error_code error;
    std::string key = map.bytes ? map.file.string() : std::filesystem::weakly_canonical(map.file, error).string();
    if (map.channel) key += fmt::format(" channel {}", map.channel);
    if (map.base_gain != glm::vec2(0, 1)) key += fmt::format(" {} + {} x", map.base_gain.x, map.base_gain.y);
    return key;
}

DecodedTexture as_texture(const TexelImage& image, TextureKind kind) {
    const bool is_color = kind == TextureKind::color && image.bits == 8;
    const VkFormat format = is_color           ? VK_FORMAT_R16G16B16A16_SFLOAT
                            : image.bits == 16 ? VK_FORMAT_R16G16B16A16_UNORM
                                               : VK_FORMAT_R8G8B8A8_UNORM;
    const glm::uvec2 size(image.width, image.height);
    return {.desc = {.format = format, .size = size},
            .channels = image.channels,
            .levels = mip_levels(format, size, is_color ? linear_halves(image.bytes) : image.bytes)};
}

}  // namespace

std::string TextureUse::key() const {
    std::string key = key_of_map(map) + (kind == TextureKind::color ? " color" : " data");
    if (as == As::normals) key += fmt::format(" as normals {}", map.bump_multiplier);
    if (as == As::roughness_metalness) key += " with " + key_of_map(metalness);
    return key;
}

DecodedTexture decode_texture(const TextureUse& use) {
    DecodedTexture texture;
    if (is_hdr_name(use.file())) {
        texture = linear_texels(use.file());
    } else {
        const bool is_data = use.kind == TextureKind::data;
        TexelImage image;
        if (use.map) image = with_options(read_map(use.map, is_data), use.map);
        if (use.as == TextureUse::As::normals) image = normals_of(std::move(image), use.map.bump_multiplier);
        if (use.as == TextureUse::As::roughness_metalness) {
            TexelImage metal;
            if (use.metalness) metal = with_options(read_map(use.metalness, is_data), use.metalness);
            image = roughness_and_metalness(image, metal);
        }
        texture = as_texture(image, use.kind);
    }
    texture.desc.name = use.file().filename().string();
    texture.desc.mips = full_mip_count(texture.desc.size);
    return texture;
}

void ImagePool::put(const TextureUse& use, const std::shared_ptr<Image>& image, int channels) {
    if (images_.try_emplace(use.key(), image).second) channels_[image.get()] = channels;
}

std::shared_ptr<Image> ImagePool::load(const TextureUse& use) {
    std::shared_ptr<Image>& entry = images_[use.key()];
    const std::string file = use.file().string();
    const auto enough = [&](int there) {
        if (there >= use.channels) return;
        throw InputError("{}: has {}, expected three or four", file, there == 1 ? "one channel" : "two channels");
    };
    if (entry) {
        enough(channels_[entry.get()]);
        return entry;
    }
    const DecodedTexture texture = unlocked([&] { return decode_texture(use); });
    const glm::uvec2 size = texture.desc.size;
    if (const uint32_t most = gpu_.device.properties.limits.maxImageDimension2D; std::max(size.x, size.y) > most)
        throw InputError("{}: {}x{} is larger than the device's {}", file, size.x, size.y, most);
    enough(texture.channels);
    auto image = std::make_shared<Image>(gpu_.device, texture.desc);
    gpu_.upload(*image, texture.levels);
    channels_[image.get()] = texture.channels;
    return entry = image;
}

std::shared_ptr<Image> ImagePool::constant(glm::vec4 value) {
    const uint32_t packed = glm::packUnorm4x8(value);
    std::shared_ptr<Image>& entry = images_[fmt::format("constant {}", packed)];
    if (entry) return entry;
    entry = std::make_shared<Image>(gpu_.device, Image::Desc{.name = "constant", .format = VK_FORMAT_R8G8B8A8_UNORM});
    gpu_.upload(*entry, std::as_bytes(std::span(&packed, 1)));
    return entry;
}

}  // namespace lightwalk
