// JSON with line numbers, for error messages.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace lightwalk {

struct JsonWithLines {
    nlohmann::json root;
    std::map<std::string, int> lines;  ///< keys: JSON pointers (RFC 6901), "/objects/0/model"; no numbers in lists
    std::string file;

    /// "file:line: key 'name'" of the value, or of its nearest enclosing value with a line.
    std::string where(const std::string& pointer) const;
};

/// Escapes a key for a JSON pointer: ~ becomes ~0, / becomes ~1.
std::string pointer_step(std::string_view key);

/// Throws InputError with file and line: invalid JSON, duplicate key, more than 64 levels, too large.
JsonWithLines parse_json(const std::string& text, const std::string& file);

}  // namespace lightwalk
