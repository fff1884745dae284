// Atomic writes of several files.
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace lightwalk {

/// Writes contents by path; if one cannot be written, none changes. Throws InputError.
void write_files(const std::map<std::filesystem::path, std::string>& files);

}  // namespace lightwalk
