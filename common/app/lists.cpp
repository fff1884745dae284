#include "common/app/lists.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/gpu/device_features.h"

namespace lightwalk {
namespace {

using nlohmann::json;

json knobs_json(const Chapter& chapter) {
    json list = json::array();
    for (const KnobBase* knob : chapter.all_knobs()) list.push_back(knob->describe());
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
    const auto features = list_optional_features();
    for (const DeviceInfo& d : list_devices()) {
        json has = json::object();
        for (const auto& [name, present] : features[list.size()]) has[name] = present;
        list.push_back(
            {{"name", d.name}, {"driver", d.driver}, {"type", d.type}, {"lacks", d.lacks}, {"features", has}});
    }
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
        std::printf("%s\n", list.dump(1, ' ', false, json::error_handler_t::replace).c_str());
    else
        print_table(list);
    return 0;
}

}  // namespace lightwalk
