#include "common/scene/image_pool.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/image/image.h"
#include "common/scene/color_levels.h"

namespace lightwalk {
namespace {

// Halves of linear values, clamped to their range; alpha is 1.
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
    const auto bytes = std::as_bytes(std::span(halves));
    return {.desc = {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = {image.width, image.height}},
            .levels = {{bytes.begin(), bytes.end()}}};
}

// One entry for each file and use of it.
std::string key_of_image(const std::filesystem::path& file, TextureKind kind) {
    std::error_code error;
    return std::filesystem::weakly_canonical(file, error).string() + (kind == TextureKind::color ? " color" : " data");
}

}  // namespace

DecodedTexture decode_texture(const std::filesystem::path& file, TextureKind kind) {
    DecodedTexture texture;
    if (is_hdr_name(file)) {
        texture = linear_texels(file);
    } else {
        TexelImage image = read_texels(file, kind == TextureKind::data);
        texture.desc.size = {image.width, image.height};
        texture.desc.format = image.bits == 16             ? VK_FORMAT_R16G16B16A16_UNORM
                              : kind == TextureKind::color ? VK_FORMAT_R8G8B8A8_SRGB
                                                           : VK_FORMAT_R8G8B8A8_UNORM;
        texture.channels = image.channels;
        if (texture.desc.format == VK_FORMAT_R8G8B8A8_SRGB)
            texture.levels = color_levels(texture.desc.size, image.bytes);
        else
            texture.levels.push_back(std::move(image.bytes));
    }
    texture.desc.name = file.filename().string();
    texture.desc.mips = full_mip_count(texture.desc.size);
    return texture;
}

void ImagePool::put(const std::filesystem::path& file, TextureKind kind, const std::shared_ptr<Image>& image,
                    int channels) {
    if (images_.try_emplace(key_of_image(file, kind), image).second) channels_[image.get()] = channels;
}

std::shared_ptr<Image> ImagePool::load(const std::filesystem::path& file, TextureKind kind, int channels) {
    std::shared_ptr<Image>& entry = images_[key_of_image(file, kind)];
    const auto enough = [&](int there) {
        if (there >= channels) return;
        throw InputError("{}: has {}, expected three or four", file.string(),
                         there == 1 ? "one channel" : "two channels");
    };
    if (entry) {
        enough(channels_[entry.get()]);
        return entry;
    }
    const DecodedTexture texture = decode_texture(file, kind);
    const glm::uvec2 size = texture.desc.size;
    if (const uint32_t most = gpu_.device.properties.limits.maxImageDimension2D; std::max(size.x, size.y) > most)
        throw InputError("{}: {}x{} is larger than the device's {}", file.string(), size.x, size.y, most);
    enough(texture.channels);
    auto image = std::make_shared<Image>(gpu_.device, texture.desc);
    if (texture.levels.size() > 1)
        gpu_.upload(*image, texture.levels);
    else
        gpu_.upload(*image, texture.levels.at(0));
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
