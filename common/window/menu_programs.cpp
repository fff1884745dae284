#include "common/window/menu_programs.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace lightwalk {

MenuPrograms::MenuPrograms(std::filesystem::path folder) : folder_(std::move(folder)) { poll(); }

bool MenuPrograms::poll() {
    if (folder_.empty()) return false;
    std::ifstream file(folder_ / "states");
    std::map<std::string, ProgramState> states;
    std::string chapter;
    for (ProgramState state; file >> chapter >> state.name >> state.done >> state.total;) states[chapter] = state;
    if (states.empty() || states == states_) return false;
    states_ = std::move(states);
    return true;
}

bool MenuPrograms::are_building() const {
    return std::any_of(states_.begin(), states_.end(), [](const auto& entry) { return entry.second.name != "ready"; });
}

ProgramState MenuPrograms::state(const std::string& chapter) const {
    const auto found = states_.find(chapter);
    return found == states_.end() ? ProgramState() : found->second;
}

void MenuPrograms::want(const std::string& chapter) {
    wanted_ = chapter;
    const std::filesystem::path beside = folder_ / "wanted.new";
    std::ofstream(beside) << chapter << '\n';
    std::error_code ignored;
    std::filesystem::rename(beside, folder_ / "wanted", ignored);
}

}  // namespace lightwalk
