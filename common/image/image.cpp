#include "common/image/image.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/image/decode.h"

namespace {

// zlib at level 4 is faster than stb's own compressor, with smaller files.
unsigned char* deflated_by_zlib(unsigned char* data, int size, int* deflated_size, int) {
    uLongf bound = compressBound(static_cast<uLong>(size));
    auto* const deflated = static_cast<unsigned char*>(std::malloc(bound));
    if (deflated && compress2(deflated, &bound, data, static_cast<uLong>(size), 4) == Z_OK) {
        *deflated_size = static_cast<int>(bound);
        return deflated;
    }
    std::free(deflated);
    return nullptr;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflated_by_zlib
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace lightwalk {
namespace fs = std::filesystem;

float srgb_to_linear(float code) { return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f); }

float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_to_linear(uint8_t code) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (size_t i = 0; i < values.size(); ++i) values[i] = srgb_to_linear(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table[code];
}

ImageRgb to_linear(const Image8& image) {
    ImageRgb linear(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::u8vec4 p = image.pixels[i];
        linear.pixels[i] = {srgb_to_linear(p.r), srgb_to_linear(p.g), srgb_to_linear(p.b)};
    }
    return linear;
}

Image8 to_srgb8(const ImageRgb& image) {
    const auto encode = [](float linear) {
        if (!(linear > 0.0f)) return uint8_t{0};
        return static_cast<uint8_t>(std::lround(linear_to_srgb(std::min(linear, 1.0f)) * 255.0f));
    };
    Image8 coded(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 p = image.pixels[i];
        coded.pixels[i] = {encode(p.r), encode(p.g), encode(p.b), 255};
    }
    return coded;
}

Image8 thumbnail(const ImageRgb& image, glm::uvec2 size) {
    const float scale = std::min(float(image.width) / float(size.x), float(image.height) / float(size.y));
    const glm::vec2 corner = 0.5f * (glm::vec2(image.width, image.height) - scale * glm::vec2(size));
    ImageRgb tile(static_cast<int>(size.x), static_cast<int>(size.y));
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const glm::ivec2 limit(image.width - 1, image.height - 1);
            const glm::ivec2 begin = glm::clamp(glm::ivec2(corner + scale * glm::vec2(x, y)), glm::ivec2(0), limit);
            const glm::ivec2 end =
                glm::clamp(glm::ivec2(corner + scale * glm::vec2(x + 1, y + 1)), begin + 1, limit + 1);
            glm::vec3 sum(0.0f);
            for (int v = begin.y; v < end.y; ++v)
                for (int u = begin.x; u < end.x; ++u) sum += image.at(u, v);
            tile.at(x, y) = sum / static_cast<float>((end.x - begin.x) * (end.y - begin.y));
        }
    return to_srgb8(tile);
}

Image8 one_step_away(const Image8& image) {
    Image8 moved = image;
    for (glm::u8vec4& p : moved.pixels)
        for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(p[c] < 255 ? p[c] + 1 : 254);
    return moved;
}

void reject(const fs::path& path, const std::string& why) {
    throw InputError("{}: {}; expected a whole PNG, JPEG, .hdr or .pfm image", path.string(), why);
}

void check_image_size(const fs::path& path, int64_t width, int64_t height) {
    if (width < 1 || height < 1) reject(path, "has no pixels");
    if (width > max_image_side || height > max_image_side || width * height > max_image_pixels)
        throw InputError("{}: {}x{} pixels is too large; at most {} a side and {} Mi pixels", path.string(), width,
                         height, max_image_side, max_image_pixels >> 20);
}

bool is_hdr_name(const fs::path& path) {
    const std::string extension = lowercase(path.extension().string());
    return extension == ".hdr" || extension == ".pfm";
}

Image8 read_image8(const fs::path& path) {
    if (is_hdr_name(path)) reject(path, "holds HDR values where 8-bit sRGB is needed");
    const Decoded file = decode_picture(path, 4, Depth::bits8);
    Image8 image(file.width, file.height);
    std::memcpy(image.pixels.data(), file.samples.data(), file.samples.size());
    return image;
}

ImageRgb read_image_linear(const fs::path& path) {
    if (lowercase(path.extension().string()) == ".pfm") return read_pfm(path);
    if (lowercase(path.extension().string()) == ".hdr") return read_radiance(path);
    const Decoded file = decode_picture(path, 4, Depth::as_stored);
    if (file.bits == 8) {
        Image8 image(file.width, file.height);
        std::memcpy(image.pixels.data(), file.samples.data(), file.samples.size());
        return to_linear(image);
    }
    ImageRgb image(file.width, file.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        std::array<uint16_t, 4> samples;
        std::memcpy(samples.data(), file.samples.data() + sizeof samples * i, sizeof samples);
        for (int c = 0; c < 3; ++c)
            image.pixels[i][c] = srgb_to_linear(static_cast<float>(samples[size_t(c)]) / 65535.0f);
    }
    return image;
}

namespace {

TexelImage texels_of(Decoded file) {
    return {.width = file.width,
            .height = file.height,
            .bits = file.bits,
            .channels = file.channels,
            .bytes = std::move(file.samples)};
}

Depth depth_of(bool keep_16_bits) { return keep_16_bits ? Depth::as_stored : Depth::bits8; }

}  // namespace

TexelImage read_texels(const fs::path& path, bool keep_16_bits) {
    return texels_of(decode_picture(path, 4, depth_of(keep_16_bits)));
}

TexelImage read_texels(const fs::path& path, std::span<const std::byte> bytes, bool keep_16_bits) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return texels_of(decode_picture(path, text, 4, depth_of(keep_16_bits)));
}

namespace {

void append(void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

}  // namespace

std::string encode_png(const Image8& image) {
    std::string bytes;
    if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(), 4 * image.width))
        throw Failure("a picture of {} x {} pixels could not be encoded as a PNG", image.width, image.height);
    return bytes;
}

std::string encode_jpeg(const Image8& image, int quality) {
    std::string bytes;
    if (!stbi_write_jpg_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(), quality))
        throw Failure("a picture of {} x {} pixels could not be encoded as a JPEG", image.width, image.height);
    return bytes;
}

void write_png(const fs::path& path, const Image8& image) {
    check_image_size(path, image.width, image.height);
    write_file(path, encode_png(image));
}

}  // namespace lightwalk
