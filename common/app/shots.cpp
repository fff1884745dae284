#include "common/app/shots.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"
#include "common/scene/json_lines.h"

namespace lightwalk {

using nlohmann::json;

namespace {

constexpr std::string_view keys[] = {"name",   "caption", "scene",     "size",   "time_s",
                                     "frames", "set",     "exercises", "rejects"};

Shot read_shot(const json& entry, const std::function<InputError(const std::string&, const std::string&)>& at) {
    if (!entry.is_object()) throw at("", "is no object { }");
    for (const auto& [key, value] : entry.items())
        if (std::ranges::find(keys, key) == std::end(keys))
            throw at("/" + key, fmt::format("is unknown here; known: {}", fmt::join(keys, ", ")));
    for (const char* const key : {"name", "caption"})
        if (entry.value(key, "").empty()) throw at("", fmt::format("has no \"{}\"", key));
    Shot shot;
    shot.name = entry["name"].get<std::string>();
    shot.caption = entry["caption"].get<std::string>();
    shot.scene = entry.value("scene", "");
    if (const json size = entry.value("size", json()); !size.is_null()) {
        const auto side = [&](size_t i) { return size.at(i).get<int64_t>(); };
        if (size.size() != 2 || side(0) < 1 || side(1) < 1 || side(0) > max_image_side || side(1) > max_image_side)
            throw at("/size",
                     fmt::format("is {}, expected two numbers, each from 1 to {}", size.dump(), max_image_side));
        shot.size = {side(0), side(1)};
    }
    shot.time_s = entry.value("time_s", 0.0f);
    shot.frames = entry.value("frames", 1);
    const json set = entry.value("set", json::object());
    if (!set.is_object()) throw at("/set", fmt::format("is {}, expected an object {{ }} of knobs", set.dump()));
    for (const auto& [name, value] : set.items())
        shot.set.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    return shot;
}

}  // namespace

std::vector<Shot> parse_shots(const std::string& text, const std::string& file) {
    const JsonWithLines source = parse_json(text, file);
    std::vector<Shot> shots;
    try {
        for (const json& entry : source.root.at("shots")) {
            const std::string pointer = fmt::format("/shots/{}", shots.size());
            shots.push_back(read_shot(entry, [&](const std::string& key, const std::string& why) {
                return InputError("{} {}", source.where(pointer + key), why);
            }));
        }
    } catch (const json::exception& e) { throw InputError("{}: {}", file, e.what()); }
    return shots;
}

std::vector<Shot> read_shots(const std::string& chapter) {
    const auto path = course_root() / "tests" / chapter / "shots.json";
    return file_exists(path) ? parse_shots(read_file(path), fmt::format("tests/{}/shots.json", chapter))
                             : std::vector<Shot>();
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
