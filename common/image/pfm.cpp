// Portable FloatMap files.
#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <string>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

static_assert(std::endian::native == std::endian::little);

[[noreturn]] void reject_pfm(const std::filesystem::path& path, const std::string& why) {
    throw InputError("{}: {}; expected \"PF\", width, height, scale and 32-bit floats", path.string(), why);
}

std::string_view next_word(std::string_view& rest) {
    size_t begin = 0;
    while (begin < rest.size() && std::isspace(static_cast<unsigned char>(rest[begin]))) ++begin;
    size_t end = begin;
    while (end < rest.size() && !std::isspace(static_cast<unsigned char>(rest[end]))) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return word;
}

template <class Number>
Number number(std::string_view word, const std::filesystem::path& path) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        reject_pfm(path, "has no number where the header needs one");
    return value;
}

}  // namespace

ImageRgb read_pfm(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    std::string_view rest = bytes;
    const std::string_view kind = next_word(rest);
    if (kind != "PF" && kind != "Pf") reject_pfm(path, "is not a PFM image");
    const int width = number<int>(next_word(rest), path);
    const int height = number<int>(next_word(rest), path);
    const bool big_endian = number<float>(next_word(rest), path) > 0.0f;
    // One byte ends the header, two where its lines end in CR LF.
    if (rest.starts_with('\n') && rest.data()[-1] == '\r') rest.remove_prefix(1);
    const int channels = kind == "PF" ? 3 : 1;
    check_image_size(path, width, height);
    const size_t row = static_cast<size_t>(width) * size_t(channels);
    if (rest.size() < row * size_t(height) * sizeof(float)) reject_pfm(path, "is cut off");

    ImageRgb image(width, height);
    for (int y = 0; y < height; ++y) {
        const char* from = rest.data() + size_t(height - 1 - y) * row * sizeof(float);
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                uint32_t bits = 0;
                std::memcpy(&bits, from + sizeof(float) * size_t(x * channels + (channels == 3 ? c : 0)), sizeof bits);
                if (big_endian) bits = __builtin_bswap32(bits);
                image.at(x, y)[c] = std::bit_cast<float>(bits);
            }
    }
    return image;
}

void write_pfm(const std::filesystem::path& path, const ImageRgb& image) {
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    for (int y = image.height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(&image.at(0, y)), size_t(image.width) * sizeof(glm::vec3));
    write_file(path, bytes);
}

}  // namespace lightwalk
