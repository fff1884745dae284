#include "common/base/starters.h"

#include <filesystem>
#include <map>
#include <sstream>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;

// Ignores white space, since editors change line ends.
uint64_t digest_of(const fs::path& file) {
    std::string text = read_file(file);
    std::erase_if(text, [](char c) { return std::string_view(" \t\n\r\v\f").find(c) != std::string_view::npos; });
    return hash_bytes(text);
}

struct Starter {
    fs::path file;
    uint64_t digest = 0;
    fs::file_time_type written{};
    uintmax_t bytes = 0;
    uint64_t answer = 0;
};

// Lines of tests/starters.txt: hexadecimal digest and path NN_name/exercise/name.
std::map<std::string, Starter, std::less<>> read_starters() {
    std::map<std::string, Starter, std::less<>> found;
    const fs::path list = course_root() / "tests" / "starters.txt";
    if (!file_exists(list)) return found;
    std::istringstream lines(read_file(list));
    for (std::string digest, name; lines >> digest >> name;) {
        const fs::path file(name), chapter = file.parent_path().parent_path().filename();
        found[chapter.string().substr(0, 2) + "." + file.stem().string()] = {
            .file = course_root() / file, .digest = std::strtoull(digest.c_str(), nullptr, 16)};
    }
    return found;
}

const Starter* find(std::string_view id) {
    static auto starters = read_starters();
    const auto found = starters.find(id);
    if (found == starters.end()) return nullptr;
    Starter& starter = found->second;
    std::error_code gone;
    const auto written = fs::last_write_time(starter.file, gone);
    const uintmax_t bytes = gone ? 0 : fs::file_size(starter.file, gone);
    if (!gone && written == starter.written && bytes == starter.bytes) return &starter;
    try {
        starter.answer = digest_of(starter.file);
        starter.written = written;
        starter.bytes = bytes;
    } catch (const InputError&) { starter.answer = 0; }
    return &starter;
}

}  // namespace

uint64_t answer_digest(std::string_view id) {
    const Starter* starter = find(id);
    return starter ? starter->answer : 0;
}

bool is_untouched(std::string_view id) {
    const Starter* starter = find(id);
    return starter && starter->answer == starter->digest;
}

}  // namespace lightwalk
