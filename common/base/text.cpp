#include "common/base/text.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <new>
#include <set>

#include "common/base/error.h"

namespace lightwalk {
namespace {

// Length of the UTF-8 character at `at`; 0 if invalid (RFC 3629: shortest form, no surrogates).
size_t utf8_length(std::string_view text, size_t at) {
    const auto byte = [&](size_t i) { return at + i < text.size() ? static_cast<uint8_t>(text[at + i]) : uint8_t{0}; };
    const uint8_t first = byte(0);
    const size_t length = first < 0x80 ? 1 : first >= 0xC2 && first < 0xE0 ? 2 : (first & 0xF0) == 0xE0 ? 3 : 4;
    if (length == 1) return 1;
    if (first < 0xC2 || first > 0xF4) return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const uint8_t second = byte(1);
    const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
    return overlong || beyond ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text, bool lines) {
    std::string out;
    for (size_t i = 0; i < text.size();) {
        const auto byte = static_cast<uint8_t>(text[i]);
        const size_t length = utf8_length(text, i);
        const bool second_controls = length == 2 && byte == 0xC2 && static_cast<uint8_t>(text[i + 1]) < 0xA0;
        const bool control = byte < 0x20 || byte == 0x7F || second_controls;
        const bool stays = lines && (byte == '\n' || byte == '\t');
        if (length > 0 && (!control || stays)) {
            out += text.substr(i, length);
            i += length;
            continue;
        }
        for (size_t end = i + std::max<size_t>(length, 1); i < end; ++i)
            out += fmt::format("\\x{:02x}", static_cast<uint8_t>(text[i]));
    }
    return out;
}

std::string*& collected_warnings() {
    static std::string* collected = nullptr;
    return collected;
}

void warn(std::string_view text) {
    const std::string line = "warning: " + printable(text) + "\n";
    if (collected_warnings())
        *collected_warnings() += line;
    else
        std::fputs(line.c_str(), stderr);
}

void warn_once(const std::string& text) {
    static std::set<std::string> said;
    static std::mutex saying;
    const std::lock_guard lock(saying);
    if (said.insert(text).second) warn(text);
}

int report_exception(const std::exception& exception, const char* prefix) {
    const auto say = [&](std::string_view why, bool lines) {
        if (why.starts_with("../")) why.remove_prefix(3);  // ccache names statements from the build folder
        std::fprintf(stderr, "%s: %s\n", prefix, printable(why, lines).c_str());
    };
    if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&exception)) {
        say(fmt::format("{}: {}", files->path1().string(), files->code().message()), false);
        return 2;
    }
    if (dynamic_cast<const InputError*>(&exception)) {
        say(exception.what(), false);
        return 2;
    }
    if (dynamic_cast<const std::bad_alloc*>(&exception))
        say("there is not enough memory for this", false);
    else
        say(exception.what(), true);
    return 1;
}

}  // namespace lightwalk
