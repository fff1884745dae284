// Images in memory, and their files.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightwalk {

/// Linear RGB, Rec. 709 primaries, rows from the top. White is 1; HDR values exceed it.
struct ImageRgb {
    int width = 0, height = 0;
    std::vector<glm::vec3> pixels;

    ImageRgb() = default;
    ImageRgb(int wide, int high, glm::vec3 fill = glm::vec3(0.0f))
        : width(wide), height(high), pixels(static_cast<size_t>(wide) * static_cast<size_t>(high), fill) {}
    glm::vec3& at(int x, int y) { return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + size_t(x)]; }
    const glm::vec3& at(int x, int y) const { return const_cast<ImageRgb*>(this)->at(x, y); }
};

inline bool all_finite(glm::vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// sRGB with straight alpha, 8 bits per channel, rows from the top.
struct Image8 {
    int width = 0, height = 0;
    std::vector<glm::u8vec4> pixels;

    Image8() = default;
    Image8(int wide, int high, glm::u8vec4 fill = glm::u8vec4(0, 0, 0, 255))
        : width(wide), height(high), pixels(static_cast<size_t>(wide) * static_cast<size_t>(high), fill) {}
    glm::u8vec4& at(int x, int y) { return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + size_t(x)]; }
    const glm::u8vec4& at(int x, int y) const { return const_cast<Image8*>(this)->at(x, y); }
};

/// Size limits for files, against damaged headers.
constexpr int max_image_side = 16384;
constexpr int64_t max_image_pixels = int64_t(1) << 27;

/// sRGB transfer functions (IEC 61966-2-1, exact piecewise form). Outside [0, 1] the curves continue, below 0 linearly.
float srgb_to_linear(float code);
float srgb_to_linear(uint8_t code);
float linear_to_srgb(float linear);

ImageRgb to_linear(const Image8& image);  ///< alpha is dropped
/// Clamps to [0, 1], encodes and rounds; NaN becomes 0, alpha 255.
Image8 to_srgb8(const ImageRgb& image);

/// The middle of the image in the shape of `size`; each pixel is the mean of its area.
Image8 thumbnail(const ImageRgb& image, glm::uvec2 size);

/// Every colour channel one 8-bit step higher (255: lower), for the reference line of charts.
Image8 one_step_away(const Image8& image);

/// True for .hdr and .pfm, ignoring case.
bool is_hdr_name(const std::filesystem::path& path);

/// Reads PNG, JPEG, BMP or TGA, rounding 16-bit samples. Throws InputError: missing, invalid, too large, HDR.
Image8 read_image8(const std::filesystem::path& path);

/// Reads any image as linear light, 16-bit sRGB at full depth. Throws InputError as read_image8().
ImageRgb read_image_linear(const std::filesystem::path& path);

/// RGBA texels for textures, rows from the top, as stored.
struct TexelImage {
    int width = 0, height = 0;
    int bits = 8;                  ///< per channel: 8, or 16 if stored and requested
    int channels = 4;              ///< channels in the file: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
    std::vector<std::byte> bytes;  ///< grey replicated; missing alpha is the maximum
};

/// Reads the formats of read_image8() without decoding. Throws InputError.
TexelImage read_texels(const std::filesystem::path& path, bool keep_16_bits);

/// Texels of an image file in memory; `path` appears in messages.
TexelImage read_texels(const std::filesystem::path& path, std::span<const std::byte> bytes, bool keep_16_bits);

/// Throws InputError, naming the file, if a side is below 1 or the limits are exceeded.
void check_image_size(const std::filesystem::path& path, int64_t width, int64_t height);

/// Writes a PNG atomically. Throws InputError.
void write_png(const std::filesystem::path& path, const Image8& image);

/// Portable FloatMap ("PF", P. Debevec): 32-bit float RGB, exact for every value including NaN; rows from the bottom,
/// negative scale for little endian. Reading also accepts grey ("Pf") and big-endian files. Throws InputError.
void write_pfm(const std::filesystem::path& path, const ImageRgb& image);
ImageRgb read_pfm(const std::filesystem::path& path);

/// Reads Radiance RGBE, flat or run-length encoded, rows from the top; divides by EXPOSURE. Throws InputError.
ImageRgb read_radiance(const std::filesystem::path& path);

}  // namespace lightwalk
