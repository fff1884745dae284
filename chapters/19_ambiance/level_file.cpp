#include "19_ambiance/level_file.h"

#include <cmath>
#include <cstring>

#include "14_environment/sound_file.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

constexpr size_t most_bytes = size_t{64} << 20;
using Codes = glm::u16vec4;

}  // namespace

std::filesystem::path levels_of(const std::filesystem::path& music) {
    return std::filesystem::path(music).replace_extension(".levels");
}

LevelTable read_levels(const std::filesystem::path& file) {
    if (!file_exists(file)) throw InputError("no file {}; --levels writes it", file.string());
    const std::string bytes = read_file(file, most_bytes);
    Levels most;
    if (bytes.size() < sizeof most || (bytes.size() - sizeof most) % sizeof(Codes) != 0)
        throw InputError("{}: cut off; --levels writes it", file.string());
    std::memcpy(&most, bytes.data(), sizeof most);
    if (!(glm::length(most) < 1e3f)) throw InputError("{}: no table of levels; --levels writes one", file.string());
    LevelTable table;
    for (size_t at = sizeof most; at < bytes.size(); at += sizeof(Codes)) {
        Codes codes;
        std::memcpy(&codes, bytes.data() + at, sizeof codes);
        table.entries.push_back(most * glm::vec4(codes) / 65535.0f);
    }
    return table;
}

void write_levels(const std::filesystem::path& music) {
    const std::filesystem::path file = find_asset(music);
    const LevelTable table = measure_levels(read_sound(file));
    const Levels most = table.most();
    std::string bytes(reinterpret_cast<const char*>(&most), sizeof most);
    for (const Levels& levels : table.entries) {
        const Codes codes(glm::round(65535.0f * levels / glm::max(most, Levels(1e-9f))));
        bytes.append(reinterpret_cast<const char*>(&codes), sizeof codes);
    }
    write_file(levels_of(file), bytes);
}

}  // namespace lightwalk
