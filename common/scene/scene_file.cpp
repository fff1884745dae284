#include "common/scene/scene_file.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string_view>

#include "common/base/files.h"
#include "common/base/names.h"
#include "common/base/text.h"
#include "common/scene/scene_reader.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

constexpr size_t deepest_include = 32, most_includes = 256, most_scene_bytes = size_t{64} << 20;

// Parents first: file order if the parent comes earlier; then, round by round, children of the previous round.
void sort_by_parent(const JsonWithLines& source, std::vector<SceneObject>& objects) {
    constexpr size_t none = SIZE_MAX, unknown = SIZE_MAX, waiting = SIZE_MAX - 1;
    std::map<std::string_view, size_t> places;
    for (size_t i = 0; i < objects.size(); ++i)
        if (!objects[i].name.empty() && !places.emplace(objects[i].name, i).second)
            throw InputError("{}: two objects are named '{}'", source.where("/objects"), objects[i].name);
    std::vector<size_t> parent(objects.size(), none), round(objects.size(), unknown), order(objects.size());
    for (size_t i = 0; i < objects.size(); ++i) {
        order[i] = i;
        if (objects[i].parent.empty()) continue;
        const auto place = places.find(objects[i].parent);
        if (place == places.end())
            throw InputError("{}: parent '{}' is no object's name", source.where("/objects"), objects[i].parent);
        parent[i] = place->second;
    }
    for (size_t i = 0; i < objects.size(); ++i) {
        std::vector<size_t> chain;
        size_t at = i;
        for (; round[at] == unknown && parent[at] != none; at = parent[at]) {
            round[at] = waiting;
            chain.push_back(at);
        }
        if (round[at] == waiting) {
            std::string names;
            for (const size_t one : chain) names += (names.empty() ? "" : ", ") + objects[one].name;
            throw InputError("{}: a cycle of parents among {}", source.where("/objects"), names);
        }
        if (round[at] == unknown) round[at] = 0;
        for (; !chain.empty(); at = chain.back(), chain.pop_back())
            round[chain.back()] = round[at] + (at > chain.back() ? 1 : 0);
    }
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return round[a] < round[b]; });
    std::vector<SceneObject> sorted;
    for (const size_t i : order) sorted.push_back(std::move(objects[i]));
    objects = std::move(sorted);
}

void check_screens(const std::vector<SceneObject>& objects) {
    for (const SceneObject& screen : objects)
        if (!screen.shows.empty() && std::none_of(objects.begin(), objects.end(), [&](const SceneObject& object) {
                return object.name == screen.shows;
            }))
            throw InputError("{} of the screen '{}' shows '{}', which is no object's name", screen.role.where,
                             screen.name, screen.shows);
}

// Stack of open files and total count, against cycles and endless includes.
struct Includes {
    std::vector<fs::path> open;
    size_t count = 0;

    std::string chain() const {
        std::string text;
        for (const fs::path& file : open) text += file.filename().string() + " includes ";
        return text;
    }
};

void read(const std::string& text, const fs::path& path, Includes& includes, SceneFile& scene);

void read_included(const fs::path& path, Includes& includes, SceneFile& scene) {
    const fs::path real = fs::weakly_canonical(path);
    const std::string chain = includes.chain() + real.filename().string();
    if (std::find(includes.open.begin(), includes.open.end(), real) != includes.open.end())
        throw InputError("{}: a cycle of includes: {}", path.string(), chain);
    if (includes.open.size() > deepest_include)
        throw InputError("{}: includes are nested more than {} deep: {}", path.string(), deepest_include, chain);
    if (includes.count++ > most_includes)
        throw InputError("{}: more than {} includes in all: {}", path.string(), most_includes, chain);
    includes.open.push_back(real);
    read(read_file(path, most_scene_bytes), path, includes, scene);
    includes.open.pop_back();
}

void read(const std::string& text, const fs::path& path, Includes& includes, SceneFile& scene) {
    const JsonWithLines source = parse_json(text, path.string());
    KeyReader r(source, source.root, "");
    if (const json* list = r.find("include")) {
        if (!list->is_array()) r.refuse("include", "must be a list of file names");
        for (size_t i = 0; i < list->size(); ++i) {
            const std::string pointer = fmt::format("/include/{}", i);
            if (!(*list)[i].is_string()) throw InputError("{} must be a file name in quotes", source.where(pointer));
            const fs::path included = path.parent_path() / (*list)[i].get<std::string>();
            if (!file_exists(included)) throw InputError("{}: no file {}", source.where(pointer), included.string());
            read_included(included, includes, scene);
        }
    }
    scene.file = path;
    if (const json* camera = r.find("camera")) read_camera(KeyReader(source, *camera, "/camera"), scene.camera);
    each(source, r, "objects", [&](KeyReader object, const std::string& pointer) {
        scene.objects.push_back(read_object(source, std::move(object), pointer));
    });
    each(source, r, "lights", [&](KeyReader reader, const std::string&) {
        bool hidden = false;
        Light light = read_light(std::move(reader), hidden);
        if (hidden)
            scene.hidden_lights.push_back({scene.lights.size(), std::move(light)});
        else
            scene.lights.push_back(std::move(light));
    });
    r.vector("ambient", scene.ambient, 0, 1e4);
    r.vector("background", scene.background, 0, 1e4);
    if (r.find("environment")) scene.environment = read_environment(source, r);
    if (r.find("music")) scene.music = read_music(source, r);
    r.boolean("bare", scene.bare);
    r.number("emission", scene.emission, 0, 1e4);
    r.string("knobs_of", scene.knobs_of);
    if (const json* knobs = r.find("knobs")) {
        if (!knobs->is_object()) r.refuse("knobs", "must be an object { name: value }");
        for (const auto& [name, value] : knobs->items())
            scene.knobs[name] = value.is_string()    ? value.get<std::string>()
                                : value.is_boolean() ? (value.get<bool>() ? "on" : "off")
                                                     : value.dump();
    }
    r.done();
    sort_by_parent(source, scene.objects);
    check_screens(scene.objects);
}

}  // namespace

SceneFile read_scene(const fs::path& path) {
    Includes includes;
    SceneFile scene;
    read_included(path, includes, scene);
    return scene;
}

SceneFile parse_scene(const std::string& text, const fs::path& path) {
    Includes includes;
    SceneFile scene;
    read(text, path, includes, scene);
    return scene;
}

namespace {

std::string nearest_files(const fs::path& path) {
    constexpr size_t most_looked_at = 10000;
    std::vector<std::string> names;
    for (const fs::path& folder : {path.parent_path(), course_root() / "assets" / path.parent_path()}) {
        std::error_code error;
        for (fs::directory_iterator file(folder.empty() ? "." : folder, error), end;
             !error && file != end && names.size() < most_looked_at; file.increment(error))
            if (std::error_code none; file->is_regular_file(none)) names.push_back(file->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::string nearest;
    for (const std::string& name : nearest_names(path.filename().string(), names))
        nearest += (nearest.empty() ? "; the nearest are " : " and ") + (path.parent_path() / name).string();
    return nearest;
}

}  // namespace

fs::path find_asset(const fs::path& path) {
    std::string why = "neither here nor below assets/";
    for (const fs::path& candidate : {path, course_root() / "assets" / path, course_root() / path}) {
        std::error_code error;
        if (fs::exists(candidate, error)) return candidate;
        if (error) why = error.message();
    }
    throw InputError("no file {}, {}{}", path.string(), why, nearest_files(path));
}

glm::mat4 local_transform(const SceneObject& object, float time_s) {
    Keyframe at{time_s, object.position, object.rotation_deg, object.scale};
    if (!object.motion.path.empty()) at = path_at(object.motion, time_s);
    glm::mat4 m = glm::translate(glm::mat4(1.0f), at.position);
    m = glm::rotate(m, glm::radians(at.rotation_deg.z), {0, 0, 1});
    m = glm::rotate(m, glm::radians(at.rotation_deg.y), {0, 1, 0});
    m = glm::rotate(m, glm::radians(at.rotation_deg.x), {1, 0, 0});
    if (object.motion.spin_deg_per_s != 0.0f)
        m = glm::rotate(m, spin_at(object.motion, time_s), glm::normalize(object.motion.axis));
    return glm::scale(m, at.scale);
}

// Hidden objects, and those below them. Parents precede children.
static std::vector<bool> hidden_objects(const SceneFile& scene) {
    std::map<std::string_view, bool> by_name;
    std::vector<bool> all;
    for (const SceneObject& object : scene.objects) {
        const auto parent = by_name.find(object.parent);
        all.push_back(object.hidden || (parent != by_name.end() && parent->second));
        if (!object.name.empty()) by_name[object.name] = all.back();
    }
    return all;
}

const SceneObject* first_shown(const SceneFile& scene, bool (*is_such)(const std::filesystem::path& model)) {
    const std::vector<bool> hidden = hidden_objects(scene);
    for (size_t i = 0; i < scene.objects.size(); ++i)
        if (!hidden[i] && is_such(scene.objects[i].model)) return &scene.objects[i];
    return nullptr;
}

// Keys of an object that place it elsewhere than at its parent's origin.
static std::string placement_keys(const SceneObject& object) {
    std::string keys;
    const auto add = [&](bool is_set, const char* key) {
        keys += is_set ? (keys.empty() ? "" : ", ") + std::string(key) : "";
    };
    add(object.position != glm::vec3(0), "position");
    add(object.rotation_deg != glm::vec3(0), "rotation_deg");
    add(object.scale != glm::vec3(1), "scale");
    add(bool(object.motion), "motion");
    return keys;
}

void name_unused_placement(const SceneFile& scene, bool (*is_such)(const std::filesystem::path& model),
                           const char* what) {
    const SceneObject* const shown = first_shown(scene, is_such);
    if (!shown) return;
    const std::vector<bool> hidden = hidden_objects(scene);
    const auto named = [](const SceneObject& object) {
        return "'" + (object.name.empty() ? object.model.filename().string() : object.name) + "'";
    };
    for (size_t i = 0; i < scene.objects.size(); ++i)
        if (const SceneObject& other = scene.objects[i]; &other != shown && !hidden[i] && is_such(other.model))
            warn_once(fmt::format("{}: {}: left out: of {} the first is drawn, {}", scene.file.string(), named(other),
                                  what, named(*shown)));
    const SceneObject* object = shown;
    for (size_t i = 0; i <= scene.objects.size() && object; ++i) {
        if (const std::string keys = placement_keys(*object); !keys.empty())
            warn_once(fmt::format("{}: {}: left out: {} of {}, which stays where it is", scene.file.string(),
                                  named(*object), keys, what));
        const auto is_parent = [&](const SceneObject& other) { return other.name == object->parent; };
        const auto parent = std::find_if(scene.objects.begin(), scene.objects.end(), is_parent);
        object = object->parent.empty() || parent == scene.objects.end() ? nullptr : &*parent;
    }
}

}  // namespace lightwalk
