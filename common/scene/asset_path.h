// File names that other programs wrote into model and material files.
#pragma once
#include <filesystem>
#include <string_view>

namespace lightwalk {

/// The file that a text in `folder` names, possibly written on Windows: quotes go, backslashes become slashes, of an
/// absolute Windows path only the file's name is kept. If there is no such file: one in other capitals, or one of that name
/// in `folder`.
std::filesystem::path resolve_file(std::string_view written, const std::filesystem::path& folder);

}  // namespace lightwalk
