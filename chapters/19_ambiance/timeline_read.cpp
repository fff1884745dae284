#include <algorithm>
#include <cmath>

#include "19_ambiance/part.h"
#include "19_ambiance/timeline.h"
#include "common/base/files.h"
#include "common/scene/scene_reader.h"

namespace lightwalk {
namespace {

constexpr size_t most_bytes = size_t{4} << 20;
constexpr double most_s = 3600;

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

double required(KeyReader& r, const std::string& pointer, const JsonWithLines& source, const char* key, double lower,
                double upper) {
    if (!r.find(key)) throw InputError("{} lacks {}", source.where(pointer), key);
    const json& given = *r.find(key);
    if (!given.is_number()) r.refuse(key, "must be a number");
    const double value = given.get<double>();
    if (!(value >= lower && value <= upper))
        r.refuse(key, fmt::format("is {}, expected {} to {}", given.dump(), json(lower).dump(), json(upper).dump()));
    return value;
}

std::string required_text(KeyReader& r, const std::string& pointer, const JsonWithLines& source, const char* key) {
    std::string text;
    if (!r.find(key)) throw InputError("{} lacks {}", source.where(pointer), key);
    r.string(key, text);
    if (text.empty()) r.refuse(key, "is empty");
    return text;
}

double optional(KeyReader& r, const std::string& pointer, const JsonWithLines& source, const char* key, double value,
                double lower, double upper) {
    return r.find(key) ? required(r, pointer, source, key, lower, upper) : value;
}

std::string value_text(KeyReader& r, const std::string& key, const json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    if (value.is_number()) return value.dump();
    if (value.is_array() && value.size() == 3) {
        std::string text;
        for (const json& one : value) {
            if (!one.is_number()) r.refuse(key, "must hold numbers");
            text += (text.empty() ? "" : ",") + one.dump();
        }
        return text;
    }
    r.refuse(key, "must be a number, three numbers, a text, true or false");
}

// A value for all of the scene, or [["steps",] [time, value], ...].
Track read_track(KeyReader& r, const JsonWithLines& source, const std::string& name, const json& value) {
    Track track{.name = name, .steps = false, .times_s = {}, .values = {}, .where = source.where(r.at(name))};
    const bool is_track = value.is_array() && !value.empty() && (value[0].is_array() || value[0] == "steps");
    if (!is_track) {
        track.times_s = {0.0};
        track.values = {value_text(r, name, value)};
        return track;
    }
    for (const json& entry : value) {
        if (entry == "steps" && track.times_s.empty() && !track.steps) {
            track.steps = true;
            continue;
        }
        if (!entry.is_array() || entry.size() != 2 || !entry[0].is_number())
            r.refuse(name, "must be a track of entries [time, value]");
        const double time_s = entry[0].get<double>();
        if (!track.times_s.empty() && !(time_s > track.times_s.back()))
            r.refuse(name,
                     fmt::format("has an entry at {} s that does not come after the one before", entry[0].dump()));
        track.times_s.push_back(time_s);
        track.values.push_back(value_text(r, name, entry[1]));
    }
    if (track.times_s.empty()) r.refuse(name, "is a track without entries");
    return track;
}

glm::dvec3 read_vector(KeyReader& r, const char* key, glm::dvec3 value) {
    glm::vec3 read(value);
    r.vector(key, read);
    return r.find(key) ? glm::dvec3(read) : value;
}

void read_path(const JsonWithLines& source, const json& object, const std::string& pointer, FilmScene& scene) {
    KeyReader r(source, object, pointer);
    std::string spline = "centripetal";
    bool even = false, smooth = true;
    r.string("spline", spline);
    r.boolean("even_speed", even);
    r.boolean("smooth_speed", smooth);
    const std::vector<std::string> splines{"linear", "catmull_rom", "centripetal"};
    const auto chosen = std::find(splines.begin(), splines.end(), spline);
    if (chosen == splines.end()) r.refuse("spline", fmt::format("is '{}', expected {}", spline, listed(splines)));
    std::vector<CameraKey> keys;
    each(source, r, "keys", [&](KeyReader k, const std::string& at) {
        CameraKey key;
        key.time_s = required(k, at, source, "time_s", -most_s, most_s);
        if (!keys.empty() && !(key.time_s > keys.back().time_s))
            k.refuse("time_s", "does not come after the key before");
        for (const char* needed : {"position", "target"})
            if (!k.find(needed)) throw InputError("{} lacks {}", source.where(at), needed);
        key.position = read_vector(k, "position", key.position);
        key.target = read_vector(k, "target", key.target);
        key.up = read_vector(k, "up", key.up);
        if (glm::length(key.up) <= 0) k.refuse("up", "has no length");
        key.fov_deg = optional(k, at, source, "fov_deg", 0, 0.1, 170);
        k.done();
        keys.push_back(key);
    });
    if (keys.empty()) throw InputError("{} lacks keys", source.where(pointer));
    r.done();
    scene.path = {static_cast<Spline>(chosen - splines.begin()), even ? 64 : 0, smooth};
    scene.camera = CameraPath(std::move(keys), scene.path);
}

std::vector<Track> read_tracks(const JsonWithLines& source, KeyReader& r) {
    std::vector<Track> tracks;
    const json* knobs = r.find("knobs");
    if (!knobs) return tracks;
    KeyReader k(source, *knobs, r.at("knobs"));
    for (const auto& [name, value] : knobs->items()) tracks.push_back(read_track(k, source, name, value));
    return tracks;
}

FilmScene read_film_scene(const JsonWithLines& source, KeyReader r, const std::string& at, double duration_s) {
    FilmScene scene;
    scene.where = source.where(at + "/scene");
    scene.name = required_text(r, at, source, "name");
    scene.kind = required_text(r, at, source, "kind");
    if (!film_worlds().contains(scene.kind)) {
        std::vector<std::string> kinds;
        for (const auto& [kind, make] : film_worlds()) kinds.push_back(kind);
        r.refuse("kind", fmt::format("is '{}', expected {}", scene.kind, listed(kinds)));
    }
    scene.file = required_text(r, at, source, "scene");
    scene.from_s = required(r, at, source, "from_s", 0, duration_s);
    scene.to_s = required(r, at, source, "to_s", 0, duration_s);
    if (!(scene.to_s > scene.from_s)) r.refuse("to_s", "is not after from_s");
    scene.clock_s = optional(r, at, source, "clock_s", 0, -1e5, 1e5);
    scene.knobs = read_tracks(source, r);
    if (const json* camera = r.find("camera")) read_path(source, *camera, r.at("camera"), scene);
    r.done();
    return scene;
}

Fade read_fade(const JsonWithLines& source, KeyReader r, const std::string& at, double duration_s) {
    Fade fade;
    fade.from_s = required(r, at, source, "from_s", 0, duration_s);
    fade.to_s = required(r, at, source, "to_s", fade.from_s, duration_s);
    fade.from = required(r, at, source, "from", 0, 1);
    fade.to = required(r, at, source, "to", 0, 1);
    std::string color = "black";
    r.string("color", color);
    if (color != "black" && color != "white") r.refuse("color", fmt::format("is '{}', expected black or white", color));
    fade.white = color == "white";
    r.done();
    return fade;
}

glm::dvec2 read_pair(KeyReader& r, const char* key, glm::dvec2 value, double lower, double upper) {
    const json* given = r.find(key);
    if (!given) return value;
    const auto number = [&](size_t i) { return (*given)[i].is_number() ? (*given)[i].get<double>() : NAN; };
    if (!given->is_array() || given->size() != 2) r.refuse(key, "must be two numbers");
    const glm::dvec2 pair{number(0), number(1)};
    for (int i = 0; i < 2; ++i)
        if (!(pair[i] >= lower && pair[i] <= upper))
            r.refuse(key, fmt::format("must be two numbers from {} to {}", json(lower).dump(), json(upper).dump()));
    return pair;
}

Title read_title(const JsonWithLines& source, KeyReader r, const std::string& at, double duration_s) {
    Title title;
    title.from_s = required(r, at, source, "from_s", 0, duration_s);
    title.to_s = required(r, at, source, "to_s", 0, duration_s);
    if (!(title.to_s > title.from_s)) r.refuse("to_s", "is not after from_s");
    title.text = required_text(r, at, source, "text");
    if (title.text.size() > 200) r.refuse("text", "is longer than 200 characters");
    title.size = optional(r, at, source, "size", 0.05, 0.005, 0.5);
    title.at = read_pair(r, "at", title.at, -4, 4);
    if (r.find("count")) title.count = read_pair(r, "count", {}, -1e15, 1e15);
    title.stays = title.to_s >= duration_s;
    r.done();
    return title;
}

Cut read_cut(const JsonWithLines& source, KeyReader r, const std::string& at, double duration_s) {
    Cut cut;
    cut.music_from_s = optional(r, at, source, "music_from_s", 0, 0, most_s);
    const json* parts = r.find("parts");
    if (!parts || !parts->is_array() || parts->empty()) throw InputError("{} lacks parts", source.where(at));
    for (const json& part : *parts) {
        const bool pair = part.is_array() && part.size() == 2 && part[0].is_number() && part[1].is_number();
        const glm::dvec2 times = pair ? glm::dvec2(part[0].get<double>(), part[1].get<double>()) : glm::dvec2(-1);
        if (!(times.x >= 0 && times.y > times.x && times.y <= duration_s))
            r.refuse("parts", fmt::format("must be pairs [from, to] within 0 and {} s", json(duration_s).dump()));
        cut.parts.push_back(times);
    }
    r.done();
    return cut;
}

// In order, each name once, and never three at once.
void check_scenes(const JsonWithLines& source, const std::vector<FilmScene>& scenes) {
    for (size_t i = 0; i < scenes.size(); ++i) {
        const std::string at = fmt::format("/scenes/{}", i);
        for (size_t k = 0; k < i; ++k)
            if (scenes[k].name == scenes[i].name)
                throw InputError("{} is '{}', as another scene is", source.where(at + "/name"), scenes[i].name);
        if (i > 0 && scenes[i].from_s < scenes[i - 1].from_s)
            throw InputError("{} is before the beginning of the scene before", source.where(at + "/from_s"));
        if (i > 0 && scenes[i].to_s < scenes[i - 1].to_s)
            throw InputError("{} is before the end of the scene before", source.where(at + "/to_s"));
        if (i > 1 && scenes[i].from_s < scenes[i - 2].to_s)
            throw InputError("{} would show three scenes at once", source.where(at + "/from_s"));
    }
}

}  // namespace

Timeline parse_timeline(const std::string& text, const std::filesystem::path& path) {
    const JsonWithLines source = parse_json(text, path.string());
    KeyReader r(source, source.root, "");
    Timeline film;
    film.file = path;
    if (r.find("music")) static_cast<SceneMusic&>(film.music) = read_music(source, r);
    if (r.find("music_gain_db")) film.music.gain_db = required(r, "", source, "music_gain_db", -60, 20);
    film.duration_s = required(r, "", source, "duration_s", 0.1, most_s);
    film.knobs = read_tracks(source, r);
    each(source, r, "scenes", [&](KeyReader scene, const std::string& at) {
        film.scenes.push_back(read_film_scene(source, std::move(scene), at, film.duration_s));
    });
    check_scenes(source, film.scenes);
    each(source, r, "fades", [&](KeyReader fade, const std::string& at) {
        film.fades.push_back(read_fade(source, std::move(fade), at, film.duration_s));
        if (film.fades.size() > 1 && film.fades.back().from_s < film.fades[film.fades.size() - 2].from_s)
            throw InputError("{} is before the fade before", source.where(at + "/from_s"));
    });
    each(source, r, "titles", [&](KeyReader title, const std::string& at) {
        film.titles.push_back(read_title(source, std::move(title), at, film.duration_s));
    });
    if (const json* cuts = r.find("cuts")) {
        KeyReader k(source, *cuts, r.at("cuts"));
        for (const auto& [name, cut] : cuts->items())
            film.cuts[name] = read_cut(source, KeyReader(source, cut, k.at(name)), k.at(name), film.duration_s);
    }
    r.done();
    return film;
}

Timeline read_timeline(const std::filesystem::path& path) { return parse_timeline(read_file(path, most_bytes), path); }

}  // namespace lightwalk
