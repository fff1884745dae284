// File names that other programs wrote into model and material files.
#pragma once
#include <filesystem>
#include <string_view>

namespace lightwalk {

/// The file that a text in `folder` names, possibly written on Windows: quotes go, backslashes become slashes, of an
/// absolute Windows path only the file's name is kept. Whether it exists is not looked at.
std::filesystem::path resolve_file(std::string_view written, const std::filesystem::path& folder);

}  // namespace lightwalk
