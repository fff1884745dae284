#include "common/image/decode.h"

#include <stb_image.h>
#include <strings.h>
#include <webp/decode.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstring>
#include <memory>
#include <new>

#include "common/base/bytes.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/image/image.h"

namespace lightwalk {
namespace fs = std::filesystem;

template <class Bytes>
void fields(Bytes& bytes, Decoded& picture) {
    bytes(picture.width, picture.height, picture.channels, picture.bits);
}

namespace {

// stb accepts truncated JPEGs: the end marker (FFD9) must follow the coded data of a scan (ITU-T T.81, B.1.1). Bytes behind
// it are no part of the picture.
bool is_cut_jpeg(std::string_view bytes) {
    if (!bytes.starts_with("\xFF\xD8")) return false;
    const auto byte = [&](size_t at) { return static_cast<uint8_t>(bytes[at]); };
    bool has_scan = false;
    for (size_t at = 2; at + 1 < bytes.size();) {
        const uint8_t code = byte(at + 1);
        // Within coded data 0 follows a byte of FF; restarts (FFD0 to FFD7) and fill bytes have no length either.
        const bool is_marker = byte(at) == 0xFF && code != 0 && code != 0xFF && !(code >= 0xD0 && code <= 0xD7);
        if (!is_marker) {
            ++at;
            continue;
        }
        if (code == 0xD9) return !has_scan;
        has_scan |= code == 0xDA;
        if (at + 3 >= bytes.size()) return true;
        at += 2u + (size_t{byte(at + 2)} << 8 | byte(at + 3));
    }
    return true;
}

// stb reports oversized PNGs as "unknown", so the header is checked first: big-endian width and height at byte 16.
void check_png_size(const fs::path& path, std::string_view bytes) {
    if (!bytes.starts_with("\x89PNG") || bytes.size() < 24) return;
    const auto number = [&](size_t at) {
        int64_t value = 0;
        for (size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
        return value;
    };
    check_image_size(path, number(16), number(20));
}

// stb input that detects reads past the end, for which stb substitutes zeros.
struct Source {
    std::string_view bytes;
    size_t at = 0;
    bool ran_out = false;

    static int read(void* user, char* to, int count) {
        Source& s = *static_cast<Source*>(user);
        const size_t given = std::min(s.bytes.size() - s.at, static_cast<size_t>(count));
        std::memcpy(to, s.bytes.data() + s.at, given);
        s.at += given;
        s.ran_out = s.ran_out || given == 0;
        return static_cast<int>(given);
    }
    static void skip(void* user, int count) {  // may be negative
        Source& s = *static_cast<Source*>(user);
        const int64_t to = static_cast<int64_t>(s.at) + count;
        s.at = static_cast<size_t>(std::clamp<int64_t>(to, 0, static_cast<int64_t>(s.bytes.size())));
    }
    static int at_end(void* user) { return static_cast<Source*>(user)->at >= static_cast<Source*>(user)->bytes.size(); }
    static constexpr stbi_io_callbacks calls{read, skip, at_end};
};

// Rejects a file for stb's reason, or for `what` if there is none. Throws std::bad_alloc if memory ran out.
[[noreturn]] void reject_as(const fs::path& path, const std::string& what) {
    const char* why = stbi_failure_reason();
    if (why && std::string_view(why) == "outofmem") throw std::bad_alloc();
    reject(path, why ? fmt::format("{} ({})", what, why) : what);
}

Decoded read_header(const fs::path& path, std::string_view bytes) {
    Decoded picture;
    Source source{bytes};
    if (!stbi_info_from_callbacks(&Source::calls, &source, &picture.width, &picture.height, &picture.channels)) {
        const bool known = bytes.starts_with("\x89PNG") || bytes.starts_with("\xFF\xD8");
        if (known) reject_as(path, "has a broken header");
        reject(path, "is not an image");
    }
    // stb reports the height of a BMP as the file has it: negative where rows run from the top.
    if (bytes.starts_with("BM") && picture.height < 0) picture.height = -std::max(picture.height, -INT_MAX);
    check_image_size(path, picture.width, picture.height);
    return picture;
}

// TGA descriptor, bit 4 of byte 17: rows run right to left, which stb ignores.
bool runs_from_right(const fs::path& path, std::string_view bytes) {
    return strcasecmp(path.extension().c_str(), ".tga") == 0 && bytes.size() > 17 && (bytes[17] & 0x10) != 0;
}

template <class Texel>
void mirror_rows(Texel* texels, int width, int height) {
    for (int y = 0; y < height; ++y) std::reverse(texels + int64_t{y} * width, texels + int64_t{y + 1} * width);
}

bool is_webp(std::string_view bytes) {
    return bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP";
}

struct Raw {
    Decoded header;
    std::unique_ptr<void, void (*)(void*)> samples;

    size_t bytes(int wanted) const { return bytes_of(header, wanted); }
    static size_t bytes_of(const Decoded& picture, int wanted) {
        return static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height) *
               static_cast<size_t>(wanted * picture.bits / 8);
    }
};

Raw decode_webp(const fs::path& path, std::string_view bytes, int wanted) {
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    WebPBitstreamFeatures header;
    if (WebPGetFeatures(data, bytes.size(), &header) != VP8_STATUS_OK) reject(path, "has a broken header");
    if (header.has_animation) reject(path, "is an animation");
    check_image_size(path, header.width, header.height);
    Decoded picture{.width = header.width, .height = header.height, .channels = header.has_alpha ? 4 : 3, .bits = 8};
    uint8_t* const pixels = WebPDecodeRGBA(data, bytes.size(), &picture.width, &picture.height);
    if (!pixels) reject(path, "is broken or cut off");
    const size_t count = Raw::bytes_of(picture, 1);
    if (wanted == 3)
        for (size_t i = 0; i < count; ++i) std::memmove(pixels + 3 * i, pixels + 4 * i, 3);
    return {picture, {pixels, WebPFree}};
}

Raw decode_here(const fs::path& path, std::string_view bytes, int wanted, Depth depth) {
    if (is_webp(bytes)) return decode_webp(path, bytes, wanted);
    Decoded picture = read_header(path, bytes);
    if (is_cut_jpeg(bytes)) reject(path, "is cut off");
    Source of_depth{bytes}, source{bytes};
    const bool has_16 = stbi_is_16_bit_from_callbacks(&Source::calls, &of_depth);
    // stb 2.27 treats these samples as 8-bit and reads twice as far.
    if (has_16 && bytes.starts_with('P')) reject(path, "is a PNM image of 16 bits");
    picture.bits = has_16 && depth == Depth::as_stored ? 16 : 8;
    // Formats with end markers can be read from memory; Source passes pieces of 128 bytes.
    const bool has_end = bytes.starts_with("\x89PNG") || bytes.starts_with("\xFF\xD8");
    int width = 0, height = 0, *channels = &picture.channels;
    const auto load = [&](auto from_memory, auto from_source) -> void* {
        const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
        if (has_end) return from_memory(data, static_cast<int>(bytes.size()), &width, &height, channels, wanted);
        return from_source(&Source::calls, &source, &width, &height, channels, wanted);
    };
    void* const pixels = has_16 ? load(stbi_load_16_from_memory, stbi_load_16_from_callbacks)
                                : load(stbi_load_from_memory, stbi_load_from_callbacks);
    if (!pixels) reject_as(path, "is broken or cut off");
    Raw raw{picture, {pixels, stbi_image_free}};
    if (width != picture.width || height != picture.height || (source.ran_out && !has_end)) reject(path, "is cut off");
    if (runs_from_right(path, bytes) && !has_16) {
        if (wanted == 4) mirror_rows(static_cast<std::array<char, 4>*>(pixels), width, height);
        if (wanted == 3) mirror_rows(static_cast<std::array<char, 3>*>(pixels), width, height);
    }
    if (has_16 && picture.bits == 8) {
        const auto* from = static_cast<const uint16_t*>(pixels);
        auto* const to = static_cast<uint8_t*>(pixels);
        const size_t count = raw.bytes(wanted);
        for (size_t i = 0; i < count; ++i) to[i] = static_cast<uint8_t>((from[i] * 255u + 32767u) / 65535u);
    }
    return raw;
}

}  // namespace

Decoded decode_picture(const fs::path& path, int wanted, Depth depth) {
    return decode_picture(path, read_file(path), wanted, depth);
}

Decoded decode_picture(const fs::path& path, const std::string& bytes, int wanted, Depth depth) {
    if (bytes.empty()) reject(path, "is empty");
    if (bytes.size() > size_t(1) << 30) reject(path, "is larger than 1 GiB");
    if (bytes.starts_with("#?")) reject(path, "is a Radiance image, which must be named .hdr");
    check_png_size(path, bytes);
    Decoded picture;
    const auto keep = [&](const void* samples) {
        const auto* const begin = static_cast<const std::byte*>(samples);
        picture.samples.assign(begin, begin + Raw::bytes_of(picture, wanted));
    };
    // files of the course are trusted
    if (!guards() || lies_below(path, course_root())) {
        const Raw raw = decode_here(path, bytes, wanted, depth);
        picture = raw.header;
        keep(raw.samples.get());
        return picture;
    }
    // Compression may reach a factor of 1000; the largest image needs 3 × 1 GiB in transit.
    const GuardLimits limits{.cpu_s = 60, .memory = size_t{5} << 30};
    const std::string said = run_guarded(path.string(), "stb_image", limits, [&] {
        const Raw raw = decode_here(path, bytes, wanted, depth);
        ByteWriter writer;
        writer(raw.header);
        return writer.bytes.append(static_cast<const char*>(raw.samples.get()), raw.bytes(wanted));
    });
    ByteReader reply(said);
    reply(picture);
    check_image_size(path, picture.width, picture.height);
    const bool as_asked = picture.bits == 8 || (picture.bits == 16 && depth == Depth::as_stored);
    const std::string_view samples = as_asked ? reply.take(Raw::bytes_of(picture, wanted)) : "";
    if (said.size() != sizeof(int) * 4 + samples.size() || !as_asked)
        throw Failure("{}: its reader answered in part", path.string());
    keep(samples.data());
    return picture;
}

}  // namespace lightwalk
