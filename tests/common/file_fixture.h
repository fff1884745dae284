// Shared by the tests of files and of readers: a folder of their own, and the message of a refusal.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/base/text.h"
#include "tests/catch.h"

namespace lightwalk {

struct FileFolder {
    static inline int made = 0;
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("lightwalk_files_{}_{}", getpid(), ++made);
    FileFolder() { std::filesystem::create_directories(path); }
    ~FileFolder() {
        std::error_code ignored;
        std::filesystem::permissions(path, std::filesystem::perms::owner_all, ignored);
        std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path operator/(const std::filesystem::path& name) const { return path / name; }
    size_t count() const { return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path), {})); }
};

/// The one line with which an action is refused; empty if it is not.
inline std::string refusal_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& e) {
        CHECK(std::string(e.what()).find('\n') == std::string::npos);
        return e.what();
    }
    return "";
}

inline bool has_part(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

}  // namespace lightwalk
