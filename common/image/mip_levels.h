// Mip generation on the CPU.
#pragma once
#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lightwalk {

/// All mips, starting with the given one; each holds `layers` layers, tightly packed. Texels are means of 2×2, rounded
/// to nearest; the last column or row of odd sizes is dropped. `format`: R8G8B8A8_UNORM or R16G16B16A16 (UNORM,
/// SFLOAT); throws Failure for others. Not by device blits, which round differently: errors of eight levels add up.
std::vector<std::vector<std::byte>> mip_levels(VkFormat format, glm::uvec2 size, std::span<const std::byte> texels,
                                               uint32_t layers = 1);

/// Converts 8-bit sRGB with linear alpha to linear R16G16B16A16_SFLOAT, the format of colour textures: Mesa's lavapipe
/// decodes sRGB by a cubic polynomial that is 16% off at code 26.
std::vector<std::byte> linear_halves(std::span<const std::byte> codes);

/// Inverse of linear_halves(), exact for each code.
std::vector<std::byte> srgb_codes(std::span<const std::byte> halves);

}  // namespace lightwalk
