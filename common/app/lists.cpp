#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/app/options.h"
#include "common/base/exercise.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/gpu/device.h"
#include "common/scene/json_lines.h"

namespace lightwalk {
namespace {

using nlohmann::json;

json knobs_json(const Chapter& chapter) {
    json list = json::array();
    for (const KnobBase* knob : chapter.knobs) list.push_back(knob->describe());
    return list;
}

json shots_json(const Chapter& chapter) {
    json list = json::array();
    for (const Shot& shot : read_shots(chapter.name))
        list.push_back({{"name", shot.name}, {"caption", shot.caption}, {"scene", shot.scene}});
    return list;
}

json exercises_json(const Chapter& chapter) {
    json list = json::array();
    for (const std::string& id : Exercises::ids())
        if (id.substr(0, 2) <= chapter.name.substr(0, 2))
            list.push_back({{"id", id},
                            {"in_use", Exercises::uses_solution(id) ? "solution" : "exercise"},
                            {"has_solution", Exercises::has_solution(id)}});
    return list;
}

json devices_json() {
    json list = json::array();
    for (const DeviceInfo& d : list_devices())
        list.push_back({{"name", d.name}, {"driver", d.driver}, {"type", d.type}, {"lacks", d.lacks}});
    return list;
}

// One line an entry: the values, the first one padded.
void print_table(const json& list) {
    for (const json& entry : list) {
        std::string line;
        for (const char* key : {"id", "name", "default", "in_use", "driver", "type", "caption", "help", "lacks"}) {
            if (!entry.contains(key)) continue;
            std::string text = entry[key].is_string() ? entry[key].get<std::string>() : entry[key].dump();
            if (line.empty()) text.resize(std::max<size_t>(text.size(), 28), ' ');
            line += (line.empty() ? "" : "  ") + text;
        }
        std::printf("%s\n", line.c_str());
    }
}

}  // namespace

int print_list(const Options& options, Chapter& chapter) {
    const json list = options.list == "knobs"       ? knobs_json(chapter)
                      : options.list == "shots"     ? shots_json(chapter)
                      : options.list == "exercises" ? exercises_json(chapter)
                                                    : devices_json();
    if (options.json)
        std::printf("%s\n", list.dump(1).c_str());
    else
        print_table(list);
    return 0;
}

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
    } catch (const json::exception& e) { throw InputError(path.string() + ": " + e.what()); }
    return shots;
}

}  // namespace lightwalk
