// Where a person's files go that nobody named: the course's tree stays as it is.
#pragma once
#include <filesystem>

namespace lightwalk {

/// $XDG_STATE_HOME/lightwalk, by default ~/.local/state/lightwalk; empty if there is no home.
std::filesystem::path state_folder();

/// For pictures and scenes: the current folder as "", or build/saved, which it makes, where that lies in the course's tree.
std::filesystem::path saving_folder();

}  // namespace lightwalk
