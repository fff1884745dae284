// Radiance .hdr format (G. Ward, "Real Pixels", Graphics Gems II, 1991; run lengths as in Radiance's color.c): text
// header, then three 8-bit mantissas and a shared exponent per pixel. Own reader, since stb_image of 2022 loops
// endlessly on truncated run-length files.
#include <cmath>
#include <cstdio>
#include <string>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

struct Reader {
    const std::filesystem::path& path;
    std::string_view rest;

    [[noreturn]] void reject(const std::string& why) const {
        throw InputError("{}: {}; expected a whole Radiance .hdr image", path.string(), why);
    }
    std::string line() {
        const size_t end = rest.find('\n');
        if (end == std::string_view::npos) reject("has a broken header");
        std::string text(rest.substr(0, end));
        if (!text.empty() && text.back() == '\r') text.pop_back();
        rest.remove_prefix(end + 1);
        return text;
    }
    uint8_t byte() {
        if (rest.empty()) reject("is cut off");
        const auto value = static_cast<uint8_t>(rest.front());
        rest.remove_prefix(1);
        return value;
    }
};

using Rgbe = glm::u8vec4;

glm::vec3 decode(Rgbe p) {
    return p.a == 0 ? glm::vec3(0.0f) : glm::vec3(p.r, p.g, p.b) * std::ldexp(1.0f, int(p.a) - (128 + 8));
}

// Components are stored separately: counts above 128 repeat the next byte, others copy.
void read_packed_row(Reader& in, std::vector<Rgbe>& row) {
    for (int component = 0; component < 4; ++component)
        for (size_t x = 0; x < row.size();) {
            const uint8_t count = in.byte();
            const bool run = count > 128;
            const size_t length = run ? count - 128u : count;
            if (length == 0 || length > row.size() - x) in.reject("has a run that leaves its row");
            uint8_t value = run ? in.byte() : uint8_t{0};
            for (size_t i = 0; i < length; ++i) row[x++][component] = run ? value : in.byte();
        }
}

// Plain pixels; (1, 1, 1, n) repeats the last one n times, and consecutive markers count 256 times as much each.
void read_flat_row(Reader& in, std::vector<Rgbe>& row, Rgbe first) {
    int shift = 0;
    for (size_t x = 0; x < row.size();) {
        const Rgbe p = x == 0 && shift == 0 ? first : Rgbe{in.byte(), in.byte(), in.byte(), in.byte()};
        if (p.r == 1 && p.g == 1 && p.b == 1 && x > 0) {
            const size_t length = shift < 24 ? size_t(p.a) << shift : row.size() + 1;
            if (length > row.size() - x) in.reject("has a run that leaves its row");
            for (size_t i = 0; i < length; ++i, ++x) row[x] = row[x - 1];
            shift += 8;
        } else {
            row[x++] = p;
            shift = 0;
        }
    }
}

}  // namespace

ImageRgb read_radiance(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    Reader in{path, bytes};
    if (!in.rest.starts_with("#?")) in.reject("is not an image");
    double exposure = 1;  // product of all EXPOSURE lines
    for (std::string text = in.line(); !text.empty(); text = in.line()) {
        if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe") in.reject("holds XYZ, not RGB");
        if (text.starts_with("EXPOSURE=")) exposure *= std::strtod(text.c_str() + 9, nullptr);
    }
    if (!(exposure > 1e-12 && exposure < 1e12)) in.reject(fmt::format("has an exposure of {:g}", exposure));
    const std::string size = in.line();
    int width = 0, height = 0, used = 0;
    if (std::sscanf(size.c_str(), "-Y %d +X %d%n", &height, &width, &used) != 2 || size_t(used) != size.size())
        in.reject(fmt::format("has no size \"-Y height +X width\" but \"{}\"", size.substr(0, 40)));
    check_image_size(path, width, height);

    ImageRgb image(width, height);
    std::vector<Rgbe> row(static_cast<size_t>(width));
    for (int y = 0; y < height; ++y) {
        const Rgbe first{in.byte(), in.byte(), in.byte(), in.byte()};  // braces fix the evaluation order
        const bool packed = width >= 8 && width < 32768 && first.r == 2 && first.g == 2 && first.b < 128;
        if (packed && (int(first.b) << 8 | first.a) != width) in.reject("has a row of another width");
        packed ? read_packed_row(in, row) : read_flat_row(in, row, first);
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = decode(row[size_t(x)]);
            if (exposure != 1) image.at(x, y) /= static_cast<float>(exposure);
        }
    }
    return image;
}

}  // namespace lightwalk
