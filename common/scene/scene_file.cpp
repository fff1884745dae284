#include "common/scene/scene_file.h"

#include <glm/gtc/matrix_transform.hpp>

#include "common/base/files.h"
#include "common/scene/scene_reader.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

// Parents first, so that transforms can be multiplied in order.
void sort_by_parent(const JsonWithLines& source, std::vector<SceneObject>& objects) {
    std::vector<SceneObject> sorted;
    std::set<std::string> placed, all;
    for (const SceneObject& o : objects)
        if (!o.name.empty() && !all.insert(o.name).second)
            throw InputError("{}: two objects are named '{}'", source.where("/objects"), o.name);
    for (const SceneObject& o : objects)
        if (!o.parent.empty() && !all.count(o.parent))
            throw InputError("{}: parent '{}' is no object's name", source.where("/objects"), o.parent);
    while (sorted.size() < objects.size()) {
        const size_t before = sorted.size();
        for (SceneObject& o : objects) {
            if (o.parent == "\n" || (!o.parent.empty() && !placed.count(o.parent))) continue;
            if (!o.name.empty()) placed.insert(o.name);
            sorted.push_back(o);
            o.parent = "\n";  // taken
        }
        if (sorted.size() > before) continue;
        std::string names;
        for (const SceneObject& o : objects)
            if (o.parent != "\n") names += (names.empty() ? "" : ", ") + o.name;
        throw InputError("{}: a cycle of parents among {}", source.where("/objects"), names);
    }
    objects = std::move(sorted);
}

void read(const std::string& text, const fs::path& path, std::vector<fs::path>& open_files, SceneFile& scene);

void read_included(const fs::path& path, std::vector<fs::path>& open_files, SceneFile& scene) {
    const fs::path real = fs::weakly_canonical(path);
    std::string chain;
    for (const fs::path& open : open_files) chain += open.filename().string() + " includes ";
    if (std::find(open_files.begin(), open_files.end(), real) != open_files.end())
        throw InputError("{}: a cycle of includes: {}{}", path.string(), chain, real.filename().string());
    open_files.push_back(real);
    read(read_file(path), path, open_files, scene);
    open_files.pop_back();
}

// Adds what the file says to `scene`: objects and lights stand after those already there, other keys replace.
void read(const std::string& text, const fs::path& path, std::vector<fs::path>& open_files, SceneFile& scene) {
    const JsonWithLines source = parse_json(text, path.string());
    KeyReader r(source, source.root, "");
    if (const json* includes = r.find("include")) {
        if (!includes->is_array()) r.refuse("include", "must be a list of file names");
        for (size_t i = 0; i < includes->size(); ++i) {
            const std::string pointer = fmt::format("/include/{}", i);
            if (!(*includes)[i].is_string())
                throw InputError("{} must be a file name in quotes", source.where(pointer));
            const fs::path included = path.parent_path() / (*includes)[i].get<std::string>();
            if (!fs::exists(included)) throw InputError("{}: no file {}", source.where(pointer), included.string());
            read_included(included, open_files, scene);
        }
    }
    scene.file = path;
    if (const json* camera = r.find("camera")) read_camera(KeyReader(source, *camera, "/camera"), scene.camera);
    each(source, r, "objects", [&](KeyReader object, const std::string& pointer) {
        scene.objects.push_back(read_object(source, std::move(object), pointer));
    });
    each(source, r, "lights",
         [&](KeyReader light, const std::string&) { scene.lights.push_back(read_light(std::move(light))); });
    r.vector("ambient", scene.ambient, 0, 1e4);
    r.vector("background", scene.background, 0, 1e4);
    if (r.find("environment")) scene.environment = read_environment(source, r);
    if (const json* knobs = r.find("knobs")) {
        if (!knobs->is_object()) r.refuse("knobs", "must be an object { name: value }");
        for (const auto& [name, value] : knobs->items())
            scene.knobs[name] = value.is_string()    ? value.get<std::string>()
                                : value.is_boolean() ? (value.get<bool>() ? "on" : "off")
                                                     : value.dump();
    }
    r.done();
    sort_by_parent(source, scene.objects);
}

}  // namespace

SceneFile read_scene(const fs::path& path) {
    std::vector<fs::path> open_files;
    SceneFile scene;
    read_included(path, open_files, scene);
    return scene;
}

SceneFile parse_scene(const std::string& text, const fs::path& path) {
    std::vector<fs::path> open_files;
    SceneFile scene;
    read(text, path, open_files, scene);
    return scene;
}

fs::path find_asset(const fs::path& path) {
    for (const fs::path& candidate : {path, course_root() / "assets" / path, course_root() / path})
        if (fs::exists(candidate)) return candidate;
    throw InputError("no file {}, neither here nor below assets/", path.string());
}

// [local_transform]
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
// [/local_transform]

}  // namespace lightwalk
