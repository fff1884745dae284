// Images in memory as numbers: read from disk, compared, and written back.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightwalk {

/// Linear RGB with Rec. 709 primaries, rows from the top. 1 is white; HDR goes above.
struct ImageRgb {
    int width = 0, height = 0;  ///< pixels
    std::vector<glm::vec3> pixels;

    ImageRgb() = default;
    ImageRgb(int wide, int high, glm::vec3 fill = glm::vec3(0.0f))
        : width(wide), height(high), pixels(static_cast<size_t>(wide) * static_cast<size_t>(high), fill) {}
    glm::vec3& at(int x, int y) { return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + size_t(x)]; }
    const glm::vec3& at(int x, int y) const { return const_cast<ImageRgb*>(this)->at(x, y); }
};

/// No channel is NaN or infinite.
inline bool all_finite(glm::vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// A screenshot's pixels: sRGB and straight alpha, 8 bits each, rows from the top.
struct Image8 {
    int width = 0, height = 0;  ///< pixels
    std::vector<glm::u8vec4> pixels;

    Image8() = default;
    Image8(int wide, int high, glm::u8vec4 fill = glm::u8vec4(0, 0, 0, 255))
        : width(wide), height(high), pixels(static_cast<size_t>(wide) * static_cast<size_t>(high), fill) {}
    glm::u8vec4& at(int x, int y) { return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + size_t(x)]; }
    const glm::u8vec4& at(int x, int y) const { return const_cast<Image8*>(this)->at(x, y); }
};

/// The largest side in pixels, and the most pixels, that a file may declare: a guard against a broken header.
constexpr int max_image_side = 16384;
constexpr int64_t max_image_pixels = int64_t(1) << 27;

/// sRGB code in [0, 1] to linear light in [0, 1] and back: IEC 61966-2-1, the exact piecewise functions. Outside
/// [0, 1] the curve goes on; below 0 it is the straight part.
float srgb_to_linear(float code);
float srgb_to_linear(uint8_t code);  ///< of 255
float linear_to_srgb(float linear);

ImageRgb to_linear(const Image8& image);  ///< Drops alpha.
/// Clamps to [0, 1], encodes and rounds to the nearest of 256 steps; NaN becomes 0, alpha 255.
Image8 to_srgb8(const ImageRgb& image);

/// Every colour channel one 8-bit step up (255 goes down): a chart's reference line "one 8-bit step".
Image8 one_step_away(const Image8& image);

/// True for the names that hold linear floats: .hdr and .pfm, in any case.
bool is_hdr_name(const std::filesystem::path& path);

/// Reads PNG, JPEG, BMP or TGA, grey or colour, 8 or 16 bits (16 are rounded to 8).
/// Throws InputError: missing, not an image, truncated, larger than max_image_side or max_image_pixels, or HDR.
Image8 read_image8(const std::filesystem::path& path);

/// Reads any image as linear light: PNG and JPEG are decoded from sRGB (16-bit ones at full depth), .hdr and .pfm
/// hold linear light already. Throws InputError as read_image8 does.
ImageRgb read_image_linear(const std::filesystem::path& path);

/// Texels as a texture takes them: RGBA, rows from the top, in the file's own depth.
struct TexelImage {
    int width = 0, height = 0;
    int bits = 8;                  ///< of a channel: 8, or 16 where the file has them and they were asked for
    int channels = 4;              ///< that the file has: 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
    std::vector<std::byte> bytes;  ///< grey fills r, g and b; a missing alpha is the largest value
};

/// Reads the files of read_image8, undecoded. Throws InputError likewise.
TexelImage read_texels(const std::filesystem::path& path, bool keep_16_bits);

/// The same of a file's bytes; `path` names it in messages.
TexelImage read_texels(const std::filesystem::path& path, std::span<const std::byte> bytes, bool keep_16_bits);

/// Throws InputError, naming the file, if a declared size is below 1 or above the limits.
void check_image_size(const std::filesystem::path& path, int64_t width, int64_t height);

/// Writes a PNG whole or not at all. Throws InputError if it cannot be written.
void write_png(const std::filesystem::path& path, const Image8& image);

/// 32-bit float RGB, exact for every value, NaN included: the Portable FloatMap ("PF", rows from the bottom, a
/// negative scale for little endian; Debevec). Reading takes grey ("Pf") and big-endian files as well.
/// Throw InputError as above.
void write_pfm(const std::filesystem::path& path, const ImageRgb& image);
ImageRgb read_pfm(const std::filesystem::path& path);

/// Radiance RGBE, flat or run-length coded, rows from the top; divided by the EXPOSURE lines before them. Throws InputError.
ImageRgb read_radiance(const std::filesystem::path& path);

}  // namespace lightwalk
