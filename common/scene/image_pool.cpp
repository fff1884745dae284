#include "common/scene/image_pool.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "common/error.h"
#include "common/files.h"

namespace lightwalk {
namespace {

struct Texels {
    glm::uvec2 size{0};
    VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
    std::vector<std::byte> bytes;
};

void keep(Texels& texels, const void* data, size_t bytes) {
    const auto* begin = static_cast<const std::byte*>(data);
    texels.bytes.assign(begin, begin + bytes);
}

Texels decode(const std::filesystem::path& file, TextureKind kind, uint32_t max_size) {
    const std::string bytes = read_file(file);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int length = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data, length, &width, &height, &channels))
        throw InputError(file.string() + ": not an image that can be read: " + stbi_failure_reason());
    if (static_cast<uint32_t>(std::max(width, height)) > max_size)
        throw InputError(file.string() + ": " + std::to_string(width) + "x" + std::to_string(height) +
                         " is larger than the device's " + std::to_string(max_size));
    Texels texels{.size = {width, height}, .bytes = {}};
    const size_t count = size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height);
    void* pixels = nullptr;
    if (stbi_is_hdr_from_memory(data, length)) {
        float* values = stbi_loadf_from_memory(data, length, &width, &height, &channels, 4);
        pixels = values;
        if (values) {
            std::vector<uint16_t> halves(count);
            for (size_t i = 0; i < count; ++i) halves[i] = glm::packHalf1x16(std::min(values[i], 65504.0f));
            texels.format = VK_FORMAT_R16G16B16A16_SFLOAT;
            keep(texels, halves.data(), count * 2);
        }
    } else if (stbi_is_16_bit_from_memory(data, length) && kind == TextureKind::data) {
        pixels = stbi_load_16_from_memory(data, length, &width, &height, &channels, 4);
        texels.format = VK_FORMAT_R16G16B16A16_UNORM;
        if (pixels) keep(texels, pixels, count * 2);
    } else {
        pixels = stbi_load_from_memory(data, length, &width, &height, &channels, 4);
        texels.format = kind == TextureKind::color ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
        if (pixels) keep(texels, pixels, count);
    }
    if (!pixels) throw InputError(file.string() + ": damaged image: " + stbi_failure_reason());
    stbi_image_free(pixels);
    return texels;
}

}  // namespace

std::shared_ptr<Image> ImagePool::load(const std::filesystem::path& file, TextureKind kind) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
    std::shared_ptr<Image>& entry = images_[real.string() + (kind == TextureKind::color ? " color" : " data")];
    if (entry) return entry;
    const Texels texels = decode(file, kind, gpu_.device.properties.limits.maxImageDimension2D);
    auto image = std::make_shared<Image>(gpu_.device, Image::Desc{.name = file.filename().string(),
                                                                  .format = texels.format,
                                                                  .size = texels.size,
                                                                  .mips = full_mip_count(texels.size)});
    gpu_.upload(*image, texels.bytes);
    return entry = image;
}

std::shared_ptr<Image> ImagePool::constant(glm::vec4 value) {
    const uint32_t packed = glm::packUnorm4x8(value);
    std::shared_ptr<Image>& entry = images_["constant " + std::to_string(packed)];
    if (entry) return entry;
    entry = std::make_shared<Image>(gpu_.device, Image::Desc{.name = "constant", .format = VK_FORMAT_R8G8B8A8_UNORM});
    gpu_.upload(*entry, std::as_bytes(std::span(&packed, 1)));
    return entry;
}

}  // namespace lightwalk
