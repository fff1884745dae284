// Which sections of a chapter's panel are open, from one run to the next.
#pragma once
#include <map>
#include <string>

namespace lightwalk {

/// By section; empty if nothing was remembered or the file cannot be read. It lies in
/// $XDG_STATE_HOME/lightwalk, by default ~/.local/state/lightwalk.
std::map<std::string, bool> read_panel_memory(const std::string& chapter);

/// Leaves everything as it is where the file cannot be written: a read-only home is no reason to disturb anybody.
void write_panel_memory(const std::string& chapter, const std::map<std::string, bool>& open);

}  // namespace lightwalk
