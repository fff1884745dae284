// Mip levels of colour textures.
#pragma once
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lightwalk {

/// All levels, the given one first, of sRGB-encoded RGBA with 8 bits each and linear alpha. A texel is the mean, in
/// linear light, of two by two of the level before; of an odd size the last column or row is left out. Made here
/// because devices encode by approximations of their own: a blit's levels differ from one maker's processor to
/// another's.
std::vector<std::vector<std::byte>> color_levels(glm::uvec2 size, std::span<const std::byte> texels);

}  // namespace lightwalk
