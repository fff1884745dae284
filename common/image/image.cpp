#include "common/image/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <string>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;

float srgb_to_linear(float code) { return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f); }

float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

ImageRgb to_linear(const Image8& image) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (size_t i = 0; i < values.size(); ++i) values[i] = srgb_to_linear(static_cast<float>(i) / 255.0f);
        return values;
    }();
    ImageRgb linear(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::u8vec4 p = image.pixels[i];
        linear.pixels[i] = {table[p.r], table[p.g], table[p.b]};
    }
    return linear;
}

Image8 to_srgb8(const ImageRgb& image) {
    const auto encode = [](float linear) {
        if (!(linear > 0.0f)) return uint8_t{0};  // NaN too
        return static_cast<uint8_t>(std::lround(linear_to_srgb(std::min(linear, 1.0f)) * 255.0f));
    };
    Image8 coded(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 p = image.pixels[i];
        coded.pixels[i] = {encode(p.r), encode(p.g), encode(p.b), 255};
    }
    return coded;
}

Image8 one_step_away(const Image8& image) {
    Image8 moved = image;
    for (glm::u8vec4& p : moved.pixels)
        for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(p[c] < 255 ? p[c] + 1 : 254);
    return moved;
}

namespace {

std::string lower_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

/// stb takes a JPEG that is cut off and fills the rest with grey. Its end marker (FFD9) must stand after the last
/// start of scan (FFDA).
bool is_cut_jpeg(const std::string& bytes) {
    if (!bytes.starts_with("\xFF\xD8")) return false;
    const size_t end = bytes.rfind("\xFF\xD9"), scan = bytes.rfind("\xFF\xDA");
    return end == std::string::npos || scan == std::string::npos || end < scan;
}

[[noreturn]] void reject(const fs::path& path, const std::string& why) {
    throw InputError("{}: {}; expected a whole PNG, JPEG, .hdr or .pfm image", path.string(), why);
}

/// stb calls a PNG it finds too large "unknown"; so its header (width and height at byte 16, big endian) is read first.
void check_png_size(const fs::path& path, const std::string& bytes) {
    if (!bytes.starts_with("\x89PNG") || bytes.size() < 24) return;
    const auto number = [&](size_t at) {
        int64_t value = 0;
        for (size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
        return value;
    };
    check_image_size(path, number(16), number(20));
}

struct Encoded {
    std::string bytes;
    const stbi_uc* data() const { return reinterpret_cast<const stbi_uc*>(bytes.data()); }
    int size() const { return static_cast<int>(bytes.size()); }
};

/// The file's bytes, its header checked.
Encoded read_encoded(const fs::path& path) {
    Encoded file{read_file(path)};
    if (file.bytes.empty()) reject(path, "is empty");
    if (file.bytes.size() > size_t(1) << 30) reject(path, "is larger than 1 GiB");
    check_png_size(path, file.bytes);
    int width = 0, height = 0, channels = 0;
    if (file.bytes.starts_with("#?")) reject(path, "is a Radiance image, which must be named .hdr");
    if (!stbi_info_from_memory(file.data(), file.size(), &width, &height, &channels)) {
        const bool known = file.bytes.starts_with("\x89PNG") || file.bytes.starts_with("\xFF\xD8");
        const char* why = stbi_failure_reason();
        reject(path, known ? fmt::format("has a broken header ({})", why ? why : "cut off") : "is not an image");
    }
    check_image_size(path, width, height);
    if (is_cut_jpeg(file.bytes)) reject(path, "is cut off");
    return file;
}

template <class Value>
struct StbFree {
    void operator()(Value* pixels) const { stbi_image_free(pixels); }
};
template <class Value>
using StbPixels = std::unique_ptr<Value[], StbFree<Value>>;

/// Wraps what an stb loader returned; null is an unreadable file.
template <class Value>
StbPixels<Value> loaded(Value* pixels, const fs::path& path) {
    if (!pixels) {
        const char* why = stbi_failure_reason();
        reject(path, why ? fmt::format("is broken or cut off ({})", why) : "is broken or cut off");
    }
    return StbPixels<Value>(pixels);
}

}  // namespace

void check_image_size(const fs::path& path, int64_t width, int64_t height) {
    if (width < 1 || height < 1) reject(path, "has no pixels");
    if (width > max_image_side || height > max_image_side || width * height > max_image_pixels)
        throw InputError("{}: {}x{} pixels is too large; at most {} a side and {} Mi pixels", path.string(), width,
                         height, max_image_side, max_image_pixels >> 20);
}

bool is_hdr_name(const fs::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".hdr" || extension == ".pfm";
}

Image8 read_image8(const fs::path& path) {
    if (is_hdr_name(path)) reject(path, "holds HDR values where 8-bit sRGB is needed");
    const Encoded file = read_encoded(path);
    int width = 0, height = 0, channels = 0;
    const auto decoded =
        loaded(stbi_load_16_from_memory(file.data(), file.size(), &width, &height, &channels, 4), path);
    Image8 image(width, height);
    // An 8-bit value v arrives as 257 v, so this rounding gives v back and rounds true 16-bit values.
    const auto round8 = [](uint16_t value) { return static_cast<uint8_t>((value * 255u + 32767u) / 65535u); };
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const uint16_t* p = &decoded[4 * i];
        image.pixels[i] = {round8(p[0]), round8(p[1]), round8(p[2]), round8(p[3])};
    }
    return image;
}

ImageRgb read_image_linear(const fs::path& path) {
    if (lower_extension(path) == ".pfm") return read_pfm(path);
    if (lower_extension(path) == ".hdr") return read_radiance(path);
    const Encoded file = read_encoded(path);
    int width = 0, height = 0, channels = 0;
    if (!stbi_is_16_bit_from_memory(file.data(), file.size())) return to_linear(read_image8(path));
    const auto decoded =
        loaded(stbi_load_16_from_memory(file.data(), file.size(), &width, &height, &channels, 3), path);
    ImageRgb image(width, height);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            image.pixels[i][c] = srgb_to_linear(static_cast<float>(decoded[3 * i + size_t(c)]) / 65535.0f);
    return image;
}

TexelImage read_texels(const fs::path& path, bool keep_16_bits) {
    const Encoded file = read_encoded(path);
    TexelImage image;
    const auto keep = [&](const void* pixels) {
        const auto* begin = static_cast<const std::byte*>(pixels);
        image.bytes.assign(begin, begin + size_t(image.width) * size_t(image.height) * size_t(image.bits / 2));
    };
    if (keep_16_bits && stbi_is_16_bit_from_memory(file.data(), file.size())) {
        image.bits = 16;
        keep(loaded(stbi_load_16_from_memory(file.data(), file.size(), &image.width, &image.height, &image.channels, 4),
                    path)
                 .get());
    } else {
        keep(loaded(stbi_load_from_memory(file.data(), file.size(), &image.width, &image.height, &image.channels, 4),
                    path)
                 .get());
    }
    return image;
}

void write_png(const fs::path& path, const Image8& image) {
    check_image_size(path, image.width, image.height);
    std::string bytes;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
    };
    if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(), 4 * image.width))
        throw Failure("{}: the PNG could not be encoded", path.string());
    write_file(path, bytes);
}

}  // namespace lightwalk
