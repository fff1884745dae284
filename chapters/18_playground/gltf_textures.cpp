#include "18_playground/gltf_textures.h"

#include <algorithm>

namespace lightwalk {
namespace {

// At the centre of a texel of an image of another size; between its own texels linear, and it repeats.
glm::vec4 sampled(const Image8& image, int x, int y, int width, int height) {
    const glm::vec2 at{(float(x) + 0.5f) * float(image.width) / float(width) - 0.5f,
                       (float(y) + 0.5f) * float(image.height) / float(height) - 0.5f};
    const glm::ivec2 low(glm::floor(at));
    const auto texel = [&](int right, int down) {
        return glm::vec4(
            image.at((low.x + right + image.width) % image.width, (low.y + down + image.height) % image.height));
    };
    const glm::vec2 part = at - glm::vec2(low);
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
}

}  // namespace

Image8 picture_of(const TextureUse& use) {
    if (is_hdr_name(use.file())) return to_srgb8(read_image_linear(use.file()));
    const DecodedTexture texture = decode_texture(use);
    const std::vector<std::byte>& texels = texture.levels.at(0);
    Image8 picture(static_cast<int>(texture.desc.size.x), static_cast<int>(texture.desc.size.y));
    const size_t step = texels.size() / (4 * picture.pixels.size());  // of 16 bits the upper eight
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c)
            picture.pixels[i][c] = std::to_integer<uint8_t>(texels[(4 * i + size_t(c)) * step + step - 1]);
    return picture;
}

Image8 color_with_opacity(const Image8& colors, const Image8& alphas) {
    Image8 both(std::max(colors.width, alphas.width), std::max(colors.height, alphas.height));
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x) {
            glm::vec4 texel = sampled(colors, x, y, both.width, both.height);
            texel.a *= sampled(alphas, x, y, both.width, both.height).r / 255.0f;
            both.at(x, y) = glm::u8vec4(glm::round(texel));
        }
    return both;
}

}  // namespace lightwalk
