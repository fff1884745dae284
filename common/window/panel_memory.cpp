#include "common/window/panel_memory.h"

#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;

constexpr size_t most_bytes = 1 << 16;

// Empty if there is no home.
fs::path memory_file(const std::string& chapter) {
    const fs::path folder = state_folder();
    return folder.empty() ? folder : folder / (chapter + ".panel.json");
}

}  // namespace

std::map<std::string, bool> read_panel_memory(const std::string& chapter) {
    const fs::path file = memory_file(chapter);
    if (file.empty() || !file_exists(file)) return {};
    try {
        const auto json = nlohmann::json::parse(read_file(file, most_bytes), nullptr, false);
        std::map<std::string, bool> open;
        if (json.is_object())
            for (const auto& [name, value] : json.items())
                if (value.is_boolean()) open[name] = value.get<bool>();
        return open;
    } catch (const InputError&) { return {}; }
}

void write_panel_memory(const std::string& chapter, const std::map<std::string, bool>& open) {
    const fs::path file = memory_file(chapter);
    std::error_code error;
    if (file.empty() || (fs::create_directories(file.parent_path(), error), error)) return;
    try {
        write_file(file, nlohmann::json(open).dump(1) + "\n");
    } catch (const InputError&) {}
}

}  // namespace lightwalk
