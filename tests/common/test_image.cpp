// Images on disk: they read back as written, and a file that is no image gives one clear line.
#include <stb_image_write.h>
#include <webp/encode.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <string>

#include "common/base/files.h"
#include "common/image/image.h"
#include "file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

Image8 pattern(int width, int height) {
    Image8 image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {uint8_t(x * 7), uint8_t(y * 11), uint8_t(x * y), uint8_t(255 - x)};
    return image;
}

/// For stb's writers: `to` is a std::string.
void append_bytes(void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size_t(size));
}

std::string message_of(const std::filesystem::path& path) {
    const std::string message = refusal_of([&] { read_image_linear(path); });
    return message.empty() ? "no error" : message;
}

/// A 16-bit grey PNG of one pixel row, 0 and 32768 and 65535, made by hand: stored (uncompressed) deflate.
std::string grey16_png() {
    const auto big_endian = [](uint32_t v) { return std::string{char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; };
    const auto chunk = [&](const std::string& type_and_data) {
        uint32_t crc = ~0u;
        for (const char c : type_and_data) {
            crc ^= uint8_t(c);
            for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
        }
        return big_endian(uint32_t(type_and_data.size() - 4)) + type_and_data + big_endian(~crc);
    };
    const std::string row("\0\0\0\x80\0\xFF\xFF", 7);
    uint32_t a = 1, b = 0;
    for (const char c : row) {
        a += uint8_t(c);
        b += a;
    }
    const std::string zlib = std::string("\x78\x01\x01\x07\x00\xF8\xFF", 7) + row + big_endian(b << 16 | a);
    return std::string("\x89PNG\r\n\x1A\n") +
           chunk("IHDR" + big_endian(3) + big_endian(1) + std::string("\x10\0\0\0\0", 5)) + chunk("IDAT" + zlib) +
           chunk("IEND");
}

/// A .hdr of the given rows, not packed.
std::string radiance(int width, int height, const std::string& rgbe) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) +
           "\n" + rgbe;
}

}  // namespace

TEST_CASE("sRGB: known values, both ways, every 8-bit step") {
    CHECK(srgb_to_linear(0.0f) == 0.0f);
    CHECK(srgb_to_linear(1.0f) == Approx(1.0));
    CHECK(srgb_to_linear(0.5f) == Approx(0.21404114).epsilon(1e-6));
    CHECK(linear_to_srgb(0.5f) == Approx(0.73535698).epsilon(1e-6));
    CHECK(linear_to_srgb(0.18f) == Approx(0.46135613).epsilon(1e-6));
    CHECK(srgb_to_linear(0.04f) == Approx(0.04 / 12.92));
    Image8 steps(256, 1);
    for (int i = 0; i < 256; ++i) steps.at(i, 0) = {uint8_t(i), uint8_t(i), uint8_t(255 - i), 255};
    CHECK(to_srgb8(to_linear(steps)).pixels == steps.pixels);
}

TEST_CASE("to_srgb8 clamps, and NaN is black") {
    ImageRgb image(1, 1, {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -3.0f});
    CHECK(to_srgb8(image).at(0, 0) == glm::u8vec4(0, 255, 0, 255));
}

TEST_CASE("A PNG comes back as it was written") {
    const FileFolder scratch;
    const Image8 image = pattern(33, 17);
    write_png(scratch / "a.png", image);
    const Image8 back = read_image8(scratch / "a.png");
    CHECK(back.width == 33);
    CHECK(back.height == 17);
    CHECK(back.pixels == image.pixels);
    CHECK(read_image_linear(scratch / "a.png").pixels == to_linear(image).pixels);
}

TEST_CASE("A 16-bit grey PNG keeps its depth in linear light and rounds to 8 bits") {
    const FileFolder scratch;
    write_file(scratch / "g.png", grey16_png());
    const ImageRgb linear = read_image_linear(scratch / "g.png");
    REQUIRE(linear.width == 3);
    CHECK(linear.at(1, 0).x == srgb_to_linear(32768.0f / 65535.0f));
    CHECK(linear.at(1, 0).x == linear.at(1, 0).z);
    const Image8 coded = read_image8(scratch / "g.png");
    CHECK(coded.at(0, 0) == glm::u8vec4(0, 0, 0, 255));
    CHECK(coded.at(1, 0) == glm::u8vec4(128, 128, 128, 255));
    CHECK(coded.at(2, 0) == glm::u8vec4(255, 255, 255, 255));
}

TEST_CASE("A PFM keeps every bit, NaN and Inf included") {
    const FileFolder scratch;
    ImageRgb image(3, 2);
    image.pixels = {
        {0, -0.0f, 1e-40f}, {1e30f, -7, .1f},
        {1, 2, 3},          {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 5},
        {6, 7, 8},          {9, 10, 11}};
    write_pfm(scratch / "a.pfm", image);
    const ImageRgb back = read_image_linear(scratch / "a.pfm");
    REQUIRE((back.width == 3 && back.height == 2));
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(std::bit_cast<uint32_t>(back.pixels[i][c]) == std::bit_cast<uint32_t>(image.pixels[i][c]));
    write_file(scratch / "grey.pfm", std::string("Pf\n1 2\n1.0\n\x3F\x80\0\0\x40\0\0\0", 19));  // big endian: 1, 2
    const ImageRgb grey = read_pfm(scratch / "grey.pfm");
    CHECK(grey.at(0, 0) == glm::vec3(2.0f));  // the last row of the file is the top one
    CHECK(grey.at(0, 1) == glm::vec3(1.0f));
    write_file(scratch / "crlf.pfm", std::string("Pf\r\n1 2\r\n1.0\r\n\x3F\x80\0\0\x40\0\0\0", 22));
    CHECK(read_pfm(scratch / "crlf.pfm").pixels == grey.pixels);
}

TEST_CASE("A .hdr is linear as it stands") {
    const FileFolder scratch;
    write_file(scratch / "a.hdr",
               radiance(2, 1, std::string("\x80\x40\x20\x81\0\0\0\0", 8)));  // mantissas * 2^(129-136)
    const ImageRgb image = read_image_linear(scratch / "a.hdr");
    REQUIRE((image.width == 2 && image.height == 1));
    CHECK(image.at(0, 0) == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(image.at(1, 0) == glm::vec3(0.0f));
    // One row of 8, each component on its own: a run of 8, then 8 as they are, then two runs.
    write_file(scratch / "packed.hdr", radiance(8, 1,
                                                std::string("\x02\x02\0\x08"
                                                            "\x88\x40"
                                                            "\x08\x01\x02\x03\x04\x05\x06\x07\x08"
                                                            "\x84\0\x84\x80"
                                                            "\x88\x88",
                                                            4 + 2 + 9 + 4 + 2)));
    const ImageRgb packed = read_image_linear(scratch / "packed.hdr");
    CHECK(packed.at(0, 0) == glm::vec3(64, 1, 0));
    CHECK(packed.at(7, 0) == glm::vec3(64, 8, 128));
    // The older form: a pixel, then the marker 1 1 1 n that repeats it.
    write_file(scratch / "old.hdr", radiance(4, 1, "\x05\x06\x07\x88\x01\x01\x01\x03"));
    CHECK(read_image_linear(scratch / "old.hdr").at(3, 0) == glm::vec3(5, 6, 7));
    write_file(scratch / "old2.hdr", radiance(4, 1, "\x05\x05\x05\x88\x09\x09\x09\x88\x01\x01\x01\x02"));
    CHECK(read_image_linear(scratch / "old2.hdr").at(3, 0) == glm::vec3(9));
    // A count of 128 copies, it does not repeat.
    std::string copies("\x02\x02\0\x80", 4);
    for (int component = 0; component < 4; ++component) {
        copies += '\x80';
        for (int x = 0; x < 128; ++x) copies += component == 3 ? '\x88' : char(x);
    }
    write_file(scratch / "copies.hdr", radiance(128, 1, copies));
    CHECK(read_image_linear(scratch / "copies.hdr").at(100, 0) == glm::vec3(100));
    // The picture was multiplied by 2 and by 4 before it was written (Radiance, "File Formats", EXPOSURE).
    std::string exposed = radiance(1, 1, "\x80\x40\x20\x84");
    exposed.insert(exposed.find("\n\n") + 1, "EXPOSURE=2\nEXPOSURE=  4.0\n");
    write_file(scratch / "exposed.hdr", exposed);
    CHECK(read_image_linear(scratch / "exposed.hdr").at(0, 0) == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(is_hdr_name("x/y.HDR"));
    CHECK_FALSE(is_hdr_name("hdr.png"));
    CHECK_THROWS_AS(read_image8(scratch / "a.hdr"), InputError);
}

TEST_CASE("What is not a whole image is refused in one line that names the file") {
    const FileFolder scratch;
    write_png(scratch / "whole.png", pattern(64, 64));
    const std::string whole = read_file(scratch / "whole.png");
    const auto refused = [&](const char* name, const std::string& bytes, const char* why) {
        write_file(scratch / name, bytes);
        const std::string message = message_of(scratch / name);
        INFO(name << ": " << message);
        CHECK(message.find((scratch / name).string()) != std::string::npos);
        CHECK(message.find(why) != std::string::npos);
        CHECK(message.find('\n') == std::string::npos);
    };
    CHECK(message_of(scratch / "missing.png").find("cannot be opened") != std::string::npos);
    CHECK(message_of(scratch.path).find("is a folder") != std::string::npos);
    refused("empty.png", "", "is empty");
    refused("text.png", "this is not an image at all, but it is long enough to look at", "is not an image");
    refused("short.webp", "RIFF", "is not an image");
    refused("header.png", whole.substr(0, 20), "broken header");
    for (const size_t keep : {whole.size() / 4, whole.size() / 2, whole.size() - 40})
        refused("cut.png", whole.substr(0, keep), "broken or cut off");
    std::string huge = whole;
    huge.replace(16, 8, std::string("\0\x0F\x42\x40\0\x0F\x42\x40", 8));  // 1,000,000 x 1,000,000
    refused("huge.png", huge, "too large");
    refused("cut.hdr", radiance(4, 4, std::string(60, 'x')), "cut off");
    refused("packed.hdr", radiance(16, 2, std::string("\x02\x02\0\x10\x90", 5)), "cut off");
    refused("run.hdr", radiance(8, 1, std::string("\x02\x02\0\x08\x89\x01", 6)), "leaves its row");
    refused("empty_run.hdr", radiance(8, 1, std::string("\x02\x02\0\x08\0\0\0\0\0\0", 10)), "leaves its row");
    refused("old_run.hdr", radiance(2, 1, "\x05\x05\x05\x05\x01\x01\x01\x09"), "leaves its row");
    refused("size.hdr", "#?RADIANCE\n\n+X 4 -Y 4\n", "no size");
    refused("large.hdr", radiance(999999, 4, ""), "too large");
    refused("cut.pfm", "PF\n2 2\n-1\nxxxx", "cut off");
    refused("word.pfm", "PF\ntwo 2\n-1\nxxxx", "no number");
    refused("kind.pfm", "P6\n2 2\n255\nxxxx", "is not a PFM");
    refused("large.pfm", "PF\n99999 99999\n-1\nxxxx", "too large");
    refused("negative.pfm", "PF\n-1 4\n-1\nxxxx", "no pixels");
    std::string jpeg;
    stbi_write_jpg_to_func(append_bytes, &jpeg, 64, 64, 4, pattern(64, 64).pixels.data(), 90);
    write_file(scratch / "whole.jpg", jpeg);
    CHECK(read_image8(scratch / "whole.jpg").width == 64);
    refused("half.jpg", jpeg.substr(0, jpeg.size() / 2), ": is cut off;");  // stb alone would fill it with grey
    // An end marker before the last scan, as a thumbnail has one, is not the end.
    refused("thumb.jpg", jpeg.substr(0, 2) + std::string("\xFF\xFE\0\x04\xFF\xD9", 6) + jpeg.substr(2, jpeg.size() / 2),
            ": is cut off;");
    refused("cut.jpg", std::string("\xFF\xD8\xFF\xE0\0\x10JFIF\0\x01\x01\0\0\x01\0\x01\0\0", 20), "broken header");
}

TEST_CASE("A PNG that cannot be written leaves nothing behind") {
    const FileFolder scratch;
    CHECK_THROWS_AS(write_png(scratch / "no/such/folder.png", pattern(4, 4)), InputError);
    CHECK_THROWS_AS(write_png(scratch / "empty.png", Image8()), InputError);
    CHECK(fs::is_empty(scratch.path));
}

TEST_CASE("corpus: every picture is read or refused") {
    const FileFolder scratch;
    size_t files = 0;
    for (const auto& entry : fs::directory_iterator(course_root() / "tests/common/corpus/image")) {
        CAPTURE(entry.path());
        const std::string bytes = read_file(entry.path());  // the first byte chose the reader, for the fuzzer
        const char* const names[] = {"a.png", "a.pfm", "a.hdr"};
        const fs::path path = scratch / names[std::min<size_t>(static_cast<size_t>(bytes.at(0)), 2)];
        write_file(path, bytes.substr(1));
        try {
            const ImageRgb image = read_image_linear(path);
            CHECK(image.width > 0);
        } catch (const InputError& error) { CHECK(std::string(error.what()).starts_with(path.string())); }
        ++files;
    }
    CHECK(files >= 10);
}

TEST_CASE("BMP, TGA and PSD are read, and refused where they are cut off") {
    const FileFolder scratch;
    const Image8 image = pattern(31, 20);
    std::string bmp, tga, psd("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\x14\0\0\0\x1f\0\x08\0\3\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 40);
    stbi_write_bmp_to_func(append_bytes, &bmp, image.width, image.height, 4, image.pixels.data());
    stbi_write_tga_to_func(append_bytes, &tga, image.width, image.height, 4, image.pixels.data());
    for (int c = 0; c < 3; ++c)
        for (const glm::u8vec4& p : image.pixels) psd += static_cast<char>(p[c]);
    const std::pair<const char*, std::string> files[] = {{"a.bmp", bmp}, {"a.tga", tga}, {"a.psd", psd}};
    for (const auto& [name, bytes] : files) {
        CAPTURE(name);
        write_file(scratch / name, bytes);
        const Image8 back = read_image8(scratch / name);
        REQUIRE((back.width == image.width && back.height == image.height));
        bool same = true;
        for (size_t i = 0; i < image.pixels.size(); ++i)
            same = same && glm::u8vec3(back.pixels[i]) == glm::u8vec3(image.pixels[i]);
        CHECK(same);
        for (const size_t length : {bytes.size() - 1, bytes.size() - 300, bytes.size() / 2}) {
            CAPTURE(length);
            write_file(scratch / name, std::string_view(bytes).substr(0, length));
            CHECK(message_of(scratch / name).find("cut off") != std::string::npos);
        }
    }
}

// Truevision TGA 2.0, image descriptor: bit 4 is the order of columns, bit 5 that of rows.
TEST_CASE("A TGA's rows run from the right where its descriptor says so") {
    const FileFolder scratch;
    const Image8 image = pattern(5, 3);
    std::string tga;
    stbi_write_tga_to_func(append_bytes, &tga, image.width, image.height, 4, image.pixels.data());
    tga[17] = static_cast<char>(tga[17] ^ 0x30);
    write_file(scratch / "turned.tga", tga);
    const Image8 turned = read_image8(scratch / "turned.tga");
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) CHECK(turned.at(x, y) == image.at(4 - x, 2 - y));
}

// Netpbm: one byte a sample up to a largest value of 255, two above it.
TEST_CASE("a PNM of 8 bits is read, and one of 16 is refused", "[common.pnm]") {
    const FileFolder scratch;
    const std::string samples = {1, 2, 3, 4, 5, 6};
    write_file(scratch / "a.ppm", "P6 2 1 255\n" + samples);
    CHECK(read_image8(scratch / "a.ppm").at(1, 0) == glm::u8vec4(4, 5, 6, 255));
    write_file(scratch / "a.ppm", "P6 2 1 65535\n" + samples + samples);
    CHECK(has_part(message_of(scratch / "a.ppm"), "is a PNM image of 16 bits"));
}

// BMP: a negative height says that rows run from the top.
TEST_CASE("a BMP whose rows run from the top", "[common.bmp_top_down]") {
    const FileFolder scratch;
    const Image8 image = pattern(5, 3);
    const auto number = [](int n) { return std::string{char(n), char(n >> 8), char(n >> 16), char(n >> 24)}; };
    std::string rows;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x)
            for (const int c : {2, 1, 0}) rows += static_cast<char>(image.at(x, y)[c]);
        rows += '\0';  // to a multiple of four bytes
    }
    write_file(scratch / "a.bmp", "BM" + number(54 + 48) + number(0) + number(54) + number(40) + number(5) +
                                      number(-3) + std::string("\1\0\x18\0", 4) + std::string(24, '\0') + rows);
    const Image8 back = read_image8(scratch / "a.bmp");
    REQUIRE((back.width == 5 && back.height == 3));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) CHECK(glm::u8vec3(back.at(x, y)) == glm::u8vec3(image.at(x, y)));
}

// ITU-T T.81, B.1.1.3: EOI ends the picture; cameras and editors put bytes behind it.
TEST_CASE("a JPEG with bytes behind its end", "[common.jpeg_ends]") {
    const FileFolder scratch;
    const Image8 image = pattern(31, 20);
    std::string jpeg;
    stbi_write_jpg_to_func(append_bytes, &jpeg, image.width, image.height, 4, image.pixels.data(), 90);
    write_file(scratch / "plain.jpg", jpeg);
    const Image8 plain = read_image8(scratch / "plain.jpg");
    for (const std::string& behind :
         {std::string("\xFF\xDA behind"), std::string(3, '\0'), jpeg.substr(0, jpeg.size() / 2)}) {
        write_file(scratch / "a.jpg", jpeg + behind);
        CHECK(read_image8(scratch / "a.jpg").pixels == plain.pixels);
    }
    write_file(scratch / "a.jpg", jpeg.substr(0, jpeg.size() - 2));
    CHECK(has_part(message_of(scratch / "a.jpg"), "cut off"));
}
