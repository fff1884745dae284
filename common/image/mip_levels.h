// Mip levels of textures, made on the processor.
#pragma once
#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lightwalk {

/// All mip levels, the given one first; each holds `layers` layers, tightly packed. A texel is the mean of 2×2 texels of the
/// level before, rounded to nearest; the last column or row of an odd size is left out. `format`: R8G8B8A8_UNORM or
/// R16G16B16A16 (UNORM or SFLOAT); throws Failure for another. Devices round a blit's texels as they like, and eight levels
/// add eight roundings.
std::vector<std::vector<std::byte>> mip_levels(VkFormat format, glm::uvec2 size, std::span<const std::byte> texels,
                                               uint32_t layers = 1);

/// sRGB codes of 8 bits with linear alpha as linear halves (R16G16B16A16_SFLOAT). Colour textures are kept like that because
/// Mesa's software driver decodes sRGB texels by a cubic polynomial, which is 16% off at code 26.
std::vector<std::byte> linear_halves(std::span<const std::byte> codes);

}  // namespace lightwalk
