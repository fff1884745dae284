#include "18_playground/utf8.h"

#include <cstdint>

#include "18_playground/commands.h"

namespace lightwalk {

size_t utf8_length(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return 1;
    const size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : byte(0) >= 0xc2 ? 2 : 0;
    if (length == 0 || byte(0) > 0xf4 || text.size() < length) return 0;
    uint32_t code = byte(0) & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3f);
    }
    const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < least[length] || surrogate || code > 0x10ffff ? 0 : length;
}

std::string clean_name(const std::string& name) {
    std::string clean;
    for (size_t i = 0; i < name.size();) {
        const size_t length = utf8_length(std::string_view(name).substr(i));
        if (length == 0)
            clean += "\xef\xbf\xbd";
        else if (length == 1 && (static_cast<unsigned char>(name[i]) < 32 || name[i] == 127))
            clean += ' ';
        else
            clean.append(name, i, length);
        i += length == 0 ? 1 : length;
    }
    return clean;
}

}  // namespace lightwalk
