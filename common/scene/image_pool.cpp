#include "common/scene/image_pool.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/image/image.h"
#include "common/scene/color_levels.h"

namespace lightwalk {
namespace {

struct Texels {
    glm::uvec2 size{0};
    VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
    int channels = 3;
    std::vector<std::byte> bytes;
};

// Halves of linear values, clamped to their range; alpha is 1.
Texels linear_texels(const std::filesystem::path& file) {
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
    return {{image.width, image.height}, VK_FORMAT_R16G16B16A16_SFLOAT, 3, {bytes.begin(), bytes.end()}};
}

Texels decode(const std::filesystem::path& file, TextureKind kind, uint32_t max_size) {
    Texels texels;
    if (is_hdr_name(file)) {
        texels = linear_texels(file);
    } else {
        TexelImage image = read_texels(file, kind == TextureKind::data);
        texels = {{image.width, image.height},
                  image.bits == 16             ? VK_FORMAT_R16G16B16A16_UNORM
                  : kind == TextureKind::color ? VK_FORMAT_R8G8B8A8_SRGB
                                               : VK_FORMAT_R8G8B8A8_UNORM,
                  image.channels,
                  std::move(image.bytes)};
    }
    if (std::max(texels.size.x, texels.size.y) > max_size)
        throw InputError("{}: {}x{} is larger than the device's {}", file.string(), texels.size.x, texels.size.y,
                         max_size);
    return texels;
}

}  // namespace

std::shared_ptr<Image> ImagePool::load(const std::filesystem::path& file, TextureKind kind, int channels) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
    std::shared_ptr<Image>& entry = images_[real.string() + (kind == TextureKind::color ? " color" : " data")];
    const auto enough = [&](int there) {
        if (there >= channels) return;
        throw InputError("{}: has {}, expected three or four", file.string(),
                         there == 1 ? "one channel" : "two channels");
    };
    if (entry) {
        enough(channels_[entry.get()]);
        return entry;
    }
    const Texels texels = decode(file, kind, gpu_.device.properties.limits.maxImageDimension2D);
    enough(texels.channels);
    auto image = std::make_shared<Image>(gpu_.device, Image::Desc{.name = file.filename().string(),
                                                                  .format = texels.format,
                                                                  .size = texels.size,
                                                                  .mips = full_mip_count(texels.size)});
    if (texels.format == VK_FORMAT_R8G8B8A8_SRGB)
        gpu_.upload(*image, color_levels(texels.size, texels.bytes));
    else
        gpu_.upload(*image, texels.bytes);
    channels_[image.get()] = texels.channels;
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
