// File names written into model and material files by other programs.
#pragma once
#include <filesystem>
#include <string_view>

namespace lightwalk {

/// File named in a model file, tolerating quotes, backslashes, other capitalisation and absolute Windows paths.
std::filesystem::path resolve_file(std::string_view written, const std::filesystem::path& folder);

}  // namespace lightwalk
