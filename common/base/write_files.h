// Several files that belong together.
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace lightwalk {

/// As write_file(), for files that belong together, by path: all are written beside their places before the first is renamed,
/// so where one cannot be written, all are as they were. Only a renaming that fails leaves some new and some old. Throws
/// InputError.
void write_files(const std::map<std::filesystem::path, std::string>& files);

}  // namespace lightwalk
