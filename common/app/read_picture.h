// Read-back of pictures from the device.
#pragma once
#include "common/gpu/gpu.h"
#include "common/image/image.h"

namespace lightwalk {

/// Value of a texel as stored: RGBA32F, RGBA16F, or RGBA8.
glm::vec4 texel_value(VkFormat format, std::span<const std::byte> texel);

/// First mip and layer as linear RGB, from half floats, floats or sRGB bytes. Blocks.
ImageRgb read_linear(Gpu& gpu, const ImageView& view);

/// First mip and layer of an 8-bit image, still encoded. Blocks.
Image8 read_picture(Gpu& gpu, const ImageView& view);

}  // namespace lightwalk
