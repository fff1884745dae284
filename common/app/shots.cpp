#include "common/app/shots.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"
#include "common/scene/json_lines.h"

namespace lightwalk {

using nlohmann::json;

namespace {

glm::uvec2 size_of(const json& size) {
    const auto side = [&](size_t i) { return size.at(i).get<int64_t>(); };
    if (size.size() != 2 || side(0) < 1 || side(1) < 1 || side(0) > max_image_side || side(1) > max_image_side)
        throw InputError("size {}: expected two numbers, each from 1 to {}", size.dump(), max_image_side);
    return {side(0), side(1)};
}

}  // namespace

std::vector<Shot> parse_shots(const std::string& text, const std::string& file) {
    const JsonWithLines source = parse_json(text, file);
    std::vector<Shot> shots;
    try {
        for (const json& entry : source.root.at("shots")) {
            Shot shot;
            shot.name = entry.at("name").get<std::string>();
            shot.caption = entry.value("caption", "");
            shot.scene = entry.value("scene", "");
            if (entry.contains("size")) shot.size = size_of(entry["size"]);
            shot.time_s = entry.value("time_s", 0.0f);
            shot.frames = entry.value("frames", 1);
            if (entry.contains("set") && !entry["set"].is_object())
                throw InputError("set of {} is {}; expected an object {{ }} of knobs", shot.name, entry["set"].dump());
            if (entry.contains("set"))
                for (const auto& [name, value] : entry["set"].items())
                    shot.set.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
            shots.push_back(std::move(shot));
        }
    } catch (const std::exception& e) { throw InputError("{}: {}", file, e.what()); }
    return shots;
}

std::vector<Shot> read_shots(const std::string& chapter) {
    const auto path = course_root() / "tests" / chapter / "shots.json";
    return file_exists(path) ? parse_shots(read_file(path), path.string()) : std::vector<Shot>();
}

std::vector<Shot> best_first(const std::string& chapter) {
    const auto path = course_root() / "tests" / chapter / "shots.json";
    std::vector<Shot> shots = read_shots(chapter);
    if (shots.empty()) return shots;
    const std::string best = parse_json(read_file(path), path.string()).root.value("best", "");
    for (Shot& shot : shots) shot.is_best = shot.name == best;
    std::stable_partition(shots.begin(), shots.end(), [](const Shot& shot) { return shot.is_best; });
    return shots;
}

}  // namespace lightwalk
