#include "common/app/read_picture.h"

#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"

namespace lightwalk {

glm::vec4 texel_value(VkFormat format, std::span<const std::byte> texel) {
    glm::vec4 value(0.0f);
    uint64_t packed = 0;
    if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
        std::memcpy(&value, texel.data(), sizeof value);
    } else if (format == VK_FORMAT_R16G16B16A16_SFLOAT) {
        std::memcpy(&packed, texel.data(), 8);
        value = glm::unpackHalf4x16(packed);
    } else {
        std::memcpy(&packed, texel.data(), 4);
        value = glm::unpackUnorm4x8(static_cast<uint32_t>(packed));
    }
    return value;
}

ImageRgb read_linear(Gpu& gpu, const ImageView& view) {
    const VkFormat format = view.image->desc.format;
    if (format == VK_FORMAT_R8G8B8A8_UNORM) return to_linear(read_picture(gpu, view));
    if (format != VK_FORMAT_R16G16B16A16_SFLOAT && format != VK_FORMAT_R32G32B32A32_SFLOAT)
        throw Failure("{} is no picture: it has neither RGBA16F, RGBA32F nor RGBA8", view.name());
    const std::vector<std::byte> texels = gpu.read_back(view);
    ImageRgb result(static_cast<int>(view.size().x), static_cast<int>(view.size().y));
    const size_t bytes = texel_bytes(format);
    for (size_t i = 0; i < result.pixels.size(); ++i)
        result.pixels[i] = glm::vec3(texel_value(format, std::span(texels).subspan(i * bytes, bytes)));
    return result;
}

Image8 read_picture(Gpu& gpu, const ImageView& view) {
    Image8 picture(static_cast<int>(view.size().x), static_cast<int>(view.size().y));
    const std::vector<std::byte> texels = gpu.read_back(view);
    std::memcpy(picture.pixels.data(), texels.data(), picture.pixels.size() * sizeof picture.pixels[0]);
    return picture;
}

}  // namespace lightwalk
