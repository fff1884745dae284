#include "common/scene/named_files.h"

#include <strings.h>

#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "common/base/files.h"

namespace lightwalk {
namespace {

int hex_digit(char c) {
    const size_t at =
        std::string_view("0123456789abcdef").find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

}  // namespace

std::string decode_uri(std::string_view text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        if (text[i] == '%' && low >= 0) {
            out += static_cast<char>(16 * high + low);
            i += 2;
        } else
            out += text[i];
    }
    return out;
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
        const std::filesystem::path file = path.parent_path() / decode_uri(name);
        if (std::filesystem::is_regular_file(file, error)) bytes += std::filesystem::file_size(file, error);
    }
    return bytes;
}

}  // namespace lightwalk
