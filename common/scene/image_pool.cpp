#include "common/scene/image_pool.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/image/image.h"
#include "common/image/mip_levels.h"
#include "common/scene/texture_options.h"

namespace lightwalk {
namespace {

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
