// Default folders for user files, outside the course's tree.
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace lightwalk {

/// $XDG_STATE_HOME/lightwalk, default ~/.local/state/lightwalk; empty without a home folder.
std::filesystem::path state_folder();

/// Folder for pictures and scenes: "" (the current one), or build/saved if that is in the course's tree.
std::filesystem::path saving_folder();

/// Writes contents by path; if one cannot be written, none changes. Throws InputError.
void write_files(const std::map<std::filesystem::path, std::string>& files);

}  // namespace lightwalk
