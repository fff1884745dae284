#include "common/app/read_picture.h"

#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"

namespace lightwalk {

ImageRgb read_linear(Gpu& gpu, const ImageView& view) {
    const VkFormat format = view.image->desc.format;
    if (format == VK_FORMAT_R8G8B8A8_UNORM) return to_linear(read_picture(gpu, view));
    const bool half = format == VK_FORMAT_R16G16B16A16_SFLOAT;
    if (!half && format != VK_FORMAT_R32G32B32A32_SFLOAT)
        throw Failure("{} is no picture: it has neither RGBA16F, RGBA32F nor RGBA8", view.name());
    const std::vector<std::byte> texels = gpu.read_back(view);
    ImageRgb result(static_cast<int>(view.size().x), static_cast<int>(view.size().y));
    for (size_t i = 0; i < result.pixels.size(); ++i) {
        uint64_t packed = 0;
        half ? std::memcpy(&packed, &texels[8 * i], 8) : std::memcpy(&result.pixels[i], &texels[16 * i], 12);
        if (half) result.pixels[i] = glm::vec3(glm::unpackHalf4x16(packed));
    }
    return result;
}

Image8 read_picture(Gpu& gpu, const ImageView& view) {
    Image8 picture(static_cast<int>(view.size().x), static_cast<int>(view.size().y));
    const std::vector<std::byte> texels = gpu.read_back(view);
    std::memcpy(picture.pixels.data(), texels.data(), picture.pixels.size() * sizeof picture.pixels[0]);
    return picture;
}

}  // namespace lightwalk
