// Shared by the tests of pictures: one to write, and the refusal of a file.
#pragma once
#include <string>

#include "common/image/image.h"
#include "file_fixture.h"

namespace lightwalk {

inline Image8 pattern(int width, int height) {
    Image8 image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {uint8_t(x * 7), uint8_t(y * 11), uint8_t(x * y), uint8_t(255 - x)};
    return image;
}

/// For stb's writers: `to` is a std::string.
inline void append_bytes(void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size_t(size));
}

inline std::string message_of(const std::filesystem::path& path) {
    const std::string message = refusal_of([&] { read_image_linear(path); });
    return message.empty() ? "no error" : message;
}

}  // namespace lightwalk
