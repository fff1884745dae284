// File names written into model and material files by other programs.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace lightwalk {

/// File named in a model file, tolerating quotes, backslashes, other capitalisation and absolute Windows paths.
std::filesystem::path resolve_file(std::string_view written, const std::filesystem::path& folder);

/// Files named in one statement, such as an OBJ file's mtllib: the whole text where such a file exists; else the longest
/// runs of words that name files, in order, and a word for each that does not. Names may be quoted.
std::vector<std::filesystem::path> resolve_files(std::string_view written, const std::filesystem::path& folder);

}  // namespace lightwalk
