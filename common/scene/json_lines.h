// JSON with the line of every value, so that an error in a scene file can name it.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace lightwalk {

struct JsonWithLines {
    nlohmann::json root;
    std::map<std::string, int> lines;  ///< by JSON pointer: "/objects/0/model"
    std::string file;

    /// "file:line: key 'name'" for messages; the nearest enclosing value's line where the pointer has none.
    std::string where(const std::string& pointer) const;
};

/// Throws InputError with file, line and reason where the text is not JSON or repeats a key.
JsonWithLines parse_json(const std::string& text, const std::string& file);

}  // namespace lightwalk
