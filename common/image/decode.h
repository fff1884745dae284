// Pictures that others wrote (PNG, JPEG, BMP, TGA, PSD, GIF), read by stb_image, in a guarded process unless they lie
// in the course's own folder.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lightwalk {

enum class Depth { bits8, as_stored };

/// Samples as the file has them, undecoded; rows from the top.
struct Decoded {
    int width = 0, height = 0;       ///< pixels
    int channels = 0;                ///< that the file has: 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
    int bits = 8;                    ///< of a sample: 8 or 16, native byte order
    std::vector<std::byte> samples;  ///< as many a pixel as were asked for
};

/// `wanted` samples a pixel, 3 or 4: grey fills r, g and b, a missing alpha is the largest value. To 8 bits a sample of
/// 16 is rounded. Throws InputError: missing, not an image, broken, cut off, larger than check_image_size() allows.
Decoded decode_picture(const std::filesystem::path& path, int wanted, Depth depth);

/// The same of a file's bytes; `path` names it in messages.
Decoded decode_picture(const std::filesystem::path& path, const std::string& bytes, int wanted, Depth depth);

/// Throws InputError "PATH: WHY; expected ..." for an unreadable picture.
[[noreturn]] void reject(const std::filesystem::path& path, const std::string& why);

}  // namespace lightwalk
