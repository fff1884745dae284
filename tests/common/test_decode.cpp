// Pictures that other programs write: read as they were written, or refused.
#include <stb_image_write.h>
#include <webp/encode.h>

#include <string>

#include "common/base/files.h"
#include "image_fixture.h"

using namespace lightwalk;

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
