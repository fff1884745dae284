#include "common/image/decode.h"

#include <stb_image.h>
#include <strings.h>
#include <webp/decode.h>

#include <algorithm>
#include <array>
#include <cstring>
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

/// stb takes a JPEG that is cut off and fills the rest with grey. Its end marker (FFD9) must stand after the last
/// start of scan (FFDA).
bool is_cut_jpeg(const std::string& bytes) {
    if (!bytes.starts_with("\xFF\xD8")) return false;
    const size_t end = bytes.rfind("\xFF\xD9"), scan = bytes.rfind("\xFF\xDA");
    return end == std::string::npos || scan == std::string::npos || end < scan;
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

/// The file as an stb source. Reads past its end return nothing; stb then assumes zeros and accepts most truncated
/// formats.
struct Source {
    const std::string& bytes;
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
    static void skip(void* user, int count) {  // back, too
        Source& s = *static_cast<Source*>(user);
        const int64_t to = static_cast<int64_t>(s.at) + count;
        s.at = static_cast<size_t>(std::clamp<int64_t>(to, 0, static_cast<int64_t>(s.bytes.size())));
    }
    static int at_end(void* user) { return static_cast<Source*>(user)->at >= static_cast<Source*>(user)->bytes.size(); }
    static constexpr stbi_io_callbacks calls{read, skip, at_end};
};

/// Throws stb's reason against a file: `what` if it gives none, and std::bad_alloc if memory ran out, which is not
/// the file's fault.
[[noreturn]] void reject_as(const fs::path& path, const std::string& what) {
    const char* why = stbi_failure_reason();
    if (why && std::string_view(why) == "outofmem") throw std::bad_alloc();
    reject(path, why ? fmt::format("{} ({})", what, why) : what);
}

Decoded read_header(const fs::path& path, const std::string& bytes) {
    Decoded picture;
    Source source{bytes};
    if (!stbi_info_from_callbacks(&Source::calls, &source, &picture.width, &picture.height, &picture.channels)) {
        const bool known = bytes.starts_with("\x89PNG") || bytes.starts_with("\xFF\xD8");
        if (known) reject_as(path, "has a broken header");
        reject(path, "is not an image");
    }
    check_image_size(path, picture.width, picture.height);
    return picture;
}

/// Bit 4 of a TGA's descriptor (byte 17): rows run from the right, which stb takes no notice of.
bool runs_from_right(const fs::path& path, const std::string& bytes) {
    return strcasecmp(path.extension().c_str(), ".tga") == 0 && bytes.size() > 17 && (bytes[17] & 0x10) != 0;
}

template <class Texel>
void mirror_rows(Texel* texels, int width, int height) {
    for (int y = 0; y < height; ++y) std::reverse(texels + int64_t{y} * width, texels + int64_t{y + 1} * width);
}

bool is_webp(const std::string& bytes) { return bytes.starts_with("RIFF") && bytes.compare(8, 4, "WEBP") == 0; }

std::string with_header(std::string samples, Decoded& picture) {
    ByteWriter tail;
    tail(picture);
    return samples + tail.bytes;
}

std::string decode_webp(const fs::path& path, const std::string& bytes, int wanted) {
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    WebPBitstreamFeatures header;
    if (WebPGetFeatures(data, bytes.size(), &header) != VP8_STATUS_OK) reject(path, "has a broken header");
    if (header.has_animation) reject(path, "is an animation");
    check_image_size(path, header.width, header.height);
    Decoded picture{.width = header.width, .height = header.height, .channels = header.has_alpha ? 4 : 3, .bits = 8};
    uint8_t* const pixels = WebPDecodeRGBA(data, bytes.size(), &picture.width, &picture.height);
    if (!pixels) reject(path, "is broken or cut off");
    const size_t count = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    std::string samples;
    samples.reserve(count * static_cast<size_t>(wanted) + 64);  // and the tail
    for (const uint8_t* p = pixels; p < pixels + 4 * count; p += 4) samples.append(p, p + wanted);
    WebPFree(pixels);
    return with_header(std::move(samples), picture);
}

/// The message through the guard's pipe: samples, then the header's fields.
std::string decode_here(const fs::path& path, const std::string& bytes, int wanted, Depth depth) {
    if (is_webp(bytes)) return decode_webp(path, bytes, wanted);
    Decoded picture = read_header(path, bytes);
    if (is_cut_jpeg(bytes)) reject(path, "is cut off");
    Source of_depth{bytes}, source{bytes};
    const bool has_16 = stbi_is_16_bit_from_callbacks(&Source::calls, &of_depth);
    picture.bits = has_16 && depth == Depth::as_stored ? 16 : 8;
    int width = 0, height = 0, *channels = &picture.channels;
    void* const pixels = has_16 ? static_cast<void*>(stbi_load_16_from_callbacks(&Source::calls, &source, &width,
                                                                                 &height, channels, wanted))
                                : stbi_load_from_callbacks(&Source::calls, &source, &width, &height, channels, wanted);
    if (!pixels) reject_as(path, "is broken or cut off");
    const bool has_end = bytes.starts_with("\x89PNG") || bytes.starts_with("\xFF\xD8");  // which stb or we look for
    if (width != picture.width || height != picture.height || (source.ran_out && !has_end)) {
        stbi_image_free(pixels);
        reject(path, "is cut off");
    }
    if (runs_from_right(path, bytes) && !has_16) {
        if (wanted == 4) mirror_rows(static_cast<std::array<char, 4>*>(pixels), width, height);
        if (wanted == 3) mirror_rows(static_cast<std::array<char, 3>*>(pixels), width, height);
    }
    const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(wanted);
    std::string result;
    if (has_16 && picture.bits == 8) {
        const auto* samples = static_cast<const uint16_t*>(pixels);
        result.reserve(count + 64);
        result.resize(count);
        for (size_t i = 0; i < count; ++i) result[i] = static_cast<char>((samples[i] * 255u + 32767u) / 65535u);
    } else {
        result.reserve(count * static_cast<size_t>(picture.bits / 8) + 64);  // and the tail
        result.assign(static_cast<const char*>(pixels), count * static_cast<size_t>(picture.bits / 8));
    }
    stbi_image_free(pixels);
    return with_header(std::move(result), picture);
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
    // A picture may be a thousand times larger than its file; the largest takes three times 1 GiB on its way.
    const GuardLimits limits{.cpu_s = 60, .memory = size_t{5} << 30};
    Decoded picture;
    const auto work = [&] { return decode_here(path, bytes, wanted, depth); };
    // A copy of a large process takes some 20 ms of it, which adds up over a scene's textures. The course's own files
    // are known to be good.
    const bool here = !guards() || lies_below(path, course_root());
    picture.samples = here ? work() : run_guarded(path.string(), "stb_image", limits, work);
    const size_t head = 4 * sizeof(int);
    if (picture.samples.size() < head) throw Failure("{}: its reader answered in part", path.string());
    ByteReader tail(std::string_view(picture.samples).substr(picture.samples.size() - head));
    tail(picture);
    picture.samples.resize(picture.samples.size() - head);
    check_image_size(path, picture.width, picture.height);
    const size_t expected = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height) *
                            static_cast<size_t>(wanted * (picture.bits == 16 ? 2 : 1));
    if (picture.samples.size() != expected) throw Failure("{}: its reader answered in part", path.string());
    return picture;
}

}  // namespace lightwalk
