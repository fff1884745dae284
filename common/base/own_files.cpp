#include "common/base/own_files.h"

#include <cstdlib>

#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;

fs::path state_folder() {
    const auto variable = [](const char* name) { return fs::path(std::getenv(name) ? std::getenv(name) : ""); };
    const fs::path state = variable("XDG_STATE_HOME"), home = variable("HOME");
    if (state.is_absolute()) return state / "lightwalk";
    if (home.is_absolute()) return home / ".local" / "state" / "lightwalk";
    return {};
}

fs::path saving_folder() {
    std::error_code error;
    const fs::path current = fs::current_path(error);
    if (error || !lies_below(current, course_root())) return {};
    const fs::path saved = course_root() / "build" / "saved";
    fs::create_directories(saved, error);
    return error ? fs::path() : saved;
}

}  // namespace lightwalk
