// Levels of an image on the host, as numbers, for measurement and display.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "07_mipmaps/mip_chain.h"
#include "common/gpu/gpu.h"

namespace lightwalk::truth {

/// Numbers of four channels, rows from the top.
struct Texels {
    glm::uvec2 size{1};
    std::vector<glm::dvec4> values;
    const glm::dvec4& at(uint32_t x, uint32_t y) const { return values[size_t(y) * size.x + x]; }
};

}  // namespace lightwalk::truth

namespace lightwalk {

/// Stored texels of the view's first mip and layer: codes from 0 to 1, halves or floats; missing channels are 0, alpha
/// 1. RGBA8, RGBA16F, RGBA16, RG16, RG16F, R16, R32F and RGBA32F. Waits. Throws Failure for another format.
truth::Texels read_texels(Gpu& gpu, const ImageView& view);

/// The same numbers as bytes of that format, rounded to nearest.
std::vector<std::byte> to_bytes(const truth::Texels& texels, VkFormat format);

/// Each texel by truth::decode.
truth::Texels decoded(truth::Texels texels, Content content);

/// Of each level of the view from the second on, how far it is from the exact mean of the first (truth::rmse).
std::vector<double> level_errors(Gpu& gpu, const ImageView& image, Content content);

}  // namespace lightwalk
