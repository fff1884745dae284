#include "common/scene/asset_path.h"

#include <strings.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;

namespace {

// Case-insensitive match, as on other operating systems; the first in order.
fs::path in_other_capitals(const fs::path& file) {
    fs::path found;
    std::error_code error;
    for (fs::directory_iterator entry(file.parent_path(), error), end; !error && entry != end; entry.increment(error))
        if (strcasecmp(entry->path().filename().c_str(), file.filename().c_str()) == 0 &&
            (found.empty() || entry->path() < found))
            found = entry->path();
    return found;
}

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Length of the first name of a list.
size_t first_name(std::string_view list, const fs::path& folder) {
    if (const size_t quote = list.find('"', 1); list.front() == '"' && quote != list.npos) return quote + 1;
    std::error_code ignored;
    const size_t word = std::min(list.find_first_of(blanks), list.size());
    for (size_t end = list.size(); end > word;) {
        if (fs::is_regular_file(resolve_file(list.substr(0, end), folder), ignored)) return end;
        end = list.find_last_not_of(blanks, list.find_last_of(blanks, end - 1)) + 1;
    }
    return word;
}

}  // namespace

std::vector<fs::path> resolve_files(std::string_view written, const fs::path& folder) {
    written = trimmed(written);
    std::error_code ignored;
    std::vector<fs::path> files{resolve_file(written, folder)};
    if (fs::exists(files[0], ignored) || written.find_first_of(blanks) == written.npos) return files;
    std::vector<fs::path> parts;
    bool any = false;
    for (std::string_view rest = written; !rest.empty();) {
        const size_t end = first_name(rest, folder);
        parts.push_back(resolve_file(rest.substr(0, end), folder));
        any |= fs::exists(parts.back(), ignored);
        rest = trimmed(rest.substr(end));
    }
    return any ? parts : files;
}

fs::path resolve_file(std::string_view written, const fs::path& folder) {
    if (written.size() > 1 && written.front() == '"' && written.back() == '"')
        written = written.substr(1, written.size() - 2);
    std::string name(written);
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.size() > 2 && name[1] == ':' && name[2] == '/') name = fs::path(name).filename();
    const fs::path file = (folder / name).lexically_normal();
    std::error_code error;
    if (fs::exists(file, error)) return file;
    for (const fs::path& near : {file, folder / file.filename()})  // moved next to the model
        if (const fs::path found = in_other_capitals(near); !found.empty()) return found;
    return file;
}

std::string decode_uri(std::string_view text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        unsigned char byte = 0;
        const char* const end = text.data() + i + 3;
        if (text[i] == '%' && i + 2 < text.size() && std::from_chars(end - 2, end, byte, 16).ptr == end) {
            out += static_cast<char>(byte);
            i += 2;
        } else
            out += text[i];
    }
    return out;
}

fs::path resolve_uri(std::string_view uri, const fs::path& folder) {
    const fs::path decoded = resolve_file(decode_uri(uri), folder), written = resolve_file(uri, folder);
    std::error_code ignored;
    return !fs::exists(decoded, ignored) && fs::exists(written, ignored) ? written : decoded;
}

size_t bytes_to_import(const std::filesystem::path& path) {
    size_t bytes = InputFile(path).bytes;
    if (strcasecmp(path.extension().c_str(), ".gltf") != 0) return bytes;
    std::set<std::string> names;
    bool is_uri = false;
    using Json = nlohmann::json;
    std::ifstream in(path, std::ios::binary);
    const auto look = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::key) {
            is_uri = parsed == "uri";
            return true;
        }
        if (event != Json::parse_event_t::value) return true;
        if (std::exchange(is_uri, false) && parsed.is_string()) names.insert(parsed.get<std::string>());
        return false;
    };
    if (Json::parse(in, look, false).is_discarded()) return bytes;
    for (const std::string& name : names) {
        if (name.starts_with("data:")) continue;
        std::error_code error;
        const std::filesystem::path file = resolve_uri(name, path.parent_path());
        if (std::filesystem::is_regular_file(file, error)) bytes += std::filesystem::file_size(file, error);
    }
    return bytes;
}

}  // namespace lightwalk
