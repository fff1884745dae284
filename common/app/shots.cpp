#include "common/app/shots.h"

#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/json_lines.h"

namespace lightwalk {

using nlohmann::json;

std::vector<Shot> read_shots(const std::string& chapter) {
    const auto path = course_root() / "tests" / chapter / "shots.json";
    if (!std::filesystem::exists(path)) return {};
    const JsonWithLines source = parse_json(read_file(path), path.string());
    std::vector<Shot> shots;
    try {
        for (const json& entry : source.root.at("shots")) {
            Shot shot;
            shot.name = entry.at("name").get<std::string>();
            shot.caption = entry.value("caption", "");
            shot.scene = entry.value("scene", "");
            if (entry.contains("size"))
                shot.size = {entry["size"].at(0).get<unsigned>(), entry["size"].at(1).get<unsigned>()};
            shot.time_s = entry.value("time_s", 0.0f);
            shot.frames = entry.value("frames", 1);
            if (entry.contains("set"))
                for (const auto& [name, value] : entry["set"].items())
                    shot.set.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
            shots.push_back(std::move(shot));
        }
    } catch (const json::exception& e) { throw InputError("{}: {}", path.string(), e.what()); }
    return shots;
}

}  // namespace lightwalk
