// JSON with the line of every value, so that an error in a scene file can name it.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace lightwalk {

struct JsonWithLines {
    nlohmann::json root;
    std::map<std::string, int> lines;  ///< by JSON pointer (RFC 6901): "/objects/0/model"; of lists' numbers none
    std::string file;

    /// "file:line: key 'name'" for messages; the nearest enclosing value's line where the pointer has none.
    std::string where(const std::string& pointer) const;
};

/// A key as a step of a pointer: ~ is ~0 and / is ~1.
std::string pointer_step(std::string_view key);

/// Throws InputError with file, line and reason where the text is not JSON, repeats a key, is nested deeper than 64
/// levels, or is so large that its pointers would fill the memory.
JsonWithLines parse_json(const std::string& text, const std::string& file);

}  // namespace lightwalk
