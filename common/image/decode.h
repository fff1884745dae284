// Image decoding by stb_image (PNG, JPEG, BMP, TGA, PSD, GIF); untrusted files in a guarded process.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "common/image/image.h"

namespace lightwalk {

enum class Depth { bits8, as_stored };

/// Samples as stored, without colour conversion; rows from the top.
struct Decoded {
    int width = 0, height = 0;
    int channels = 0;                ///< channels in the file: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
    int bits = 8;                    ///< per sample, 8 or 16; native byte order
    std::vector<std::byte> samples;  ///< interleaved, `wanted` per pixel
};

/// Decodes `wanted` (3 or 4) samples per pixel: grey is replicated, missing alpha is the maximum. Depth::bits8 rounds
/// 16-bit samples. Throws InputError: missing, no image, damaged, truncated, larger than check_image_size() allows.
Decoded decode_picture(const std::filesystem::path& path, int wanted, Depth depth);

/// Decodes an image file in memory; `path` appears in messages.
Decoded decode_picture(const std::filesystem::path& path, const std::string& bytes, int wanted, Depth depth);

/// Throws InputError "PATH: WHY; expected ...".
[[noreturn]] void reject(const std::filesystem::path& path, const std::string& why);

/// PNG with alpha. Throws Failure if out of memory.
std::string encode_png(const Image8& image);

/// JPEG without alpha; `quality` 1 to 100. Throws Failure if out of memory.
std::string encode_jpeg(const Image8& image, int quality);

}  // namespace lightwalk
