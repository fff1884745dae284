#include "common/scene/scene_file.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/json_lines.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

// One object of the file while it is read: hands out its keys and refuses those nobody asked for.
class Reader {
  public:
    Reader(const JsonWithLines& source, const json& object, std::string pointer)
        : source_(source), object_(object), pointer_(std::move(pointer)) {
        if (!object.is_object()) throw InputError(source.where(pointer_) + " must be an object { }");
    }

    void number(const char* key, float& value, double lower, double upper) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_number()) refuse(key, "must be a number");
        const double number = given->get<double>();
        if (!(number >= lower && number <= upper))
            refuse(key, "is " + given->dump() + ", expected " + text(lower) + " to " + text(upper));
        value = static_cast<float>(number);
    }
    void angle(const char* key, float& value_rad, double lower_deg, double upper_deg) {
        float degrees = glm::degrees(value_rad);
        number(key, degrees, lower_deg, upper_deg);
        value_rad = glm::radians(degrees);
    }
    void vector(const char* key, glm::vec3& value, double lower = -1e9, double upper = 1e9) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_array() || given->size() != 3) refuse(key, "must be three numbers [x, y, z]");
        for (int i = 0; i < 3; ++i) {
            const json& item = (*given)[static_cast<size_t>(i)];
            if (!item.is_number()) refuse(key, "must be three numbers [x, y, z]");
            const double number = item.get<double>();
            if (!(number >= lower && number <= upper))
                refuse(key, "holds " + item.dump() + ", expected " + text(lower) + " to " + text(upper));
            value[i] = static_cast<float>(number);
        }
    }
    void string(const char* key, std::string& value) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_string()) refuse(key, "must be a text in quotes");
        value = given->get<std::string>();
    }
    const json* find(const char* key) {
        known_.insert(key);
        const auto it = object_.find(key);
        return it == object_.end() ? nullptr : &*it;
    }
    std::string at(const std::string& key) const { return pointer_ + "/" + key; }
    [[noreturn]] void refuse(const std::string& key, const std::string& why) const {
        throw InputError(source_.where(at(key)) + " " + why);
    }
    void done() const {
        for (const auto& [key, value] : object_.items()) {
            if (known_.count(key)) continue;
            std::string names;
            for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
            throw InputError(source_.where(at(key)) + " is unknown here; known: " + names);
        }
    }

  private:
    static std::string text(double value) { return json(value).dump(); }
    const JsonWithLines& source_;
    const json& object_;
    std::string pointer_;
    std::set<std::string> known_;
};

template <class F>
void each(const JsonWithLines& source, Reader& parent, const char* key, F read) {
    const json* list = parent.find(key);
    if (!list) return;
    if (!list->is_array()) parent.refuse(key, "must be a list [ ]");
    for (size_t i = 0; i < list->size(); ++i) {
        const std::string pointer = parent.at(key) + "/" + std::to_string(i);
        read(Reader(source, (*list)[i], pointer), pointer);
    }
}

fs::path asset(const JsonWithLines& source, const std::string& pointer, const std::string& name) {
    try {
        find_asset(name);
    } catch (const InputError& e) { throw InputError(source.where(pointer) + ": " + e.what()); }
    return name;
}

void read_camera(Reader r, Camera& camera) {
    r.vector("position", camera.position);
    r.vector("target", camera.target);
    r.vector("up", camera.up, -1, 1);
    r.angle("fov_deg", camera.fov_y_rad, 1, 170);
    r.number("near_m", camera.near_m, 1e-5, 1e5);
    r.number("far_m", camera.far_m, 1e-4, 1e9);
    r.done();
    const glm::vec3 view = camera.target - camera.position;
    if (glm::length(view) == 0.0f) r.refuse("target", "is where the camera stands: it would look nowhere");
    if (glm::length(glm::cross(view, camera.up)) == 0.0f) r.refuse("up", "points along the view");
    if (camera.far_m <= camera.near_m) r.refuse("far_m", "must be above near_m");
}

MaterialOverride read_material(const JsonWithLines& source, Reader r) {
    MaterialOverride material;
    const auto color = [&](const char* key, std::optional<glm::vec3>& value, double most) {
        glm::vec3 v(0.0f);
        if (!r.find(key)) return;
        r.vector(key, v, 0, most);
        value = v;
    };
    const auto number = [&](const char* key, std::optional<float>& value, double lower, double upper) {
        float v = 0;
        if (!r.find(key)) return;
        r.number(key, v, lower, upper);
        value = v;
    };
    color("diffuse", material.diffuse, 1);
    color("specular", material.specular, 1);
    color("emissive", material.emissive, 1e4);
    number("shininess", material.shininess, 0, 1e5);
    number("opacity", material.opacity, 0, 1);
    number("roughness", material.roughness, 0, 1);
    number("metalness", material.metalness, 0, 1);
    if (const json* maps = r.find("maps")) {
        if (!maps->is_object()) r.refuse("maps", "must be an object { slot: file }");
        for (const auto& [slot, file] : maps->items()) {
            const std::string pointer = r.at("maps") + "/" + slot;
            if (!file.is_string()) throw InputError(source.where(pointer) + " must be a file name in quotes");
            material.maps[slot] = asset(source, pointer, file.get<std::string>());
        }
    }
    r.done();
    return material;
}

SceneObject read_object(const JsonWithLines& source, Reader r, const std::string& pointer) {
    SceneObject object;
    std::string model;
    r.string("name", object.name);
    r.string("parent", object.parent);
    r.string("model", model);
    if (!model.empty()) object.model = asset(source, pointer + "/model", model);
    r.vector("position", object.position);
    r.vector("rotation_deg", object.rotation_deg);
    if (const json* scale = r.find("scale"); scale && scale->is_number()) {
        float s = 1;
        r.number("scale", s, -1e6, 1e6);
        object.scale = glm::vec3(s);
    } else {
        r.vector("scale", object.scale, -1e6, 1e6);
    }
    for (int i = 0; i < 3; ++i)
        if (object.scale[i] == 0.0f) r.refuse("scale", "is 0: nothing would be left of the object");
    if (const json* material = r.find("material"))
        object.material = read_material(source, Reader(source, *material, pointer + "/material"));
    r.done();
    return object;
}

Light read_light(Reader r) {
    Light light;
    std::string kind = "directional";
    r.string("type", kind);
    if (kind == "point")
        light.kind = Light::Kind::point;
    else if (kind == "spot")
        light.kind = Light::Kind::spot;
    else if (kind != "directional")
        r.refuse("type", "is '" + kind + "', expected directional, point or spot");
    r.vector("color", light.color, 0, 1);
    r.number("intensity", light.intensity, 0, 1e6);
    if (light.kind != Light::Kind::point) {
        r.vector("direction", light.direction);
        if (glm::length(light.direction) == 0.0f) r.refuse("direction", "has no length");
        light.direction = glm::normalize(light.direction);
    }
    if (light.kind != Light::Kind::directional) {
        r.vector("position", light.position);
        r.number("range_m", light.range_m, 0, 1e6);
    }
    if (light.kind == Light::Kind::spot) {
        r.angle("inner_deg", light.inner_rad, 0, 180);
        r.angle("outer_deg", light.outer_rad, 0, 180);
        r.number("softness", light.softness, 0, 1);
        if (light.inner_rad > light.outer_rad) r.refuse("inner_deg", "is above outer_deg");
    }
    r.done();
    return light;
}

// Parents first, so that transforms can be multiplied in order.
void sort_by_parent(const JsonWithLines& source, std::vector<SceneObject>& objects) {
    std::vector<SceneObject> sorted;
    std::set<std::string> placed, all;
    for (const SceneObject& o : objects)
        if (!o.name.empty() && !all.insert(o.name).second)
            throw InputError(source.where("/objects") + ": two objects are named '" + o.name + "'");
    for (const SceneObject& o : objects)
        if (!o.parent.empty() && !all.count(o.parent))
            throw InputError(source.where("/objects") + ": parent '" + o.parent + "' is no object's name");
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
        throw InputError(source.where("/objects") + ": a cycle of parents among " + names);
    }
    objects = std::move(sorted);
}

SceneFile read(const std::string& text, const fs::path& path, std::vector<fs::path>& open_files);

SceneFile read_included(const fs::path& path, std::vector<fs::path>& open_files) {
    const fs::path real = fs::weakly_canonical(path);
    std::string chain;
    for (const fs::path& open : open_files) chain += open.filename().string() + " includes ";
    if (std::find(open_files.begin(), open_files.end(), real) != open_files.end())
        throw InputError(path.string() + ": a cycle of includes: " + chain + real.filename().string());
    open_files.push_back(real);
    SceneFile scene = read(read_file(path), path, open_files);
    open_files.pop_back();
    return scene;
}

SceneFile read(const std::string& text, const fs::path& path, std::vector<fs::path>& open_files) {
    const JsonWithLines source = parse_json(text, path.string());
    Reader r(source, source.root, "");
    SceneFile scene;
    if (const json* includes = r.find("include")) {
        if (!includes->is_array()) r.refuse("include", "must be a list of file names");
        for (size_t i = 0; i < includes->size(); ++i) {
            const std::string pointer = "/include/" + std::to_string(i);
            if (!(*includes)[i].is_string()) throw InputError(source.where(pointer) + " must be a file name in quotes");
            const fs::path included = path.parent_path() / (*includes)[i].get<std::string>();
            if (!fs::exists(included)) throw InputError(source.where(pointer) + ": no file " + included.string());
            SceneFile other = read_included(included, open_files);
            other.objects.insert(other.objects.begin(), scene.objects.begin(), scene.objects.end());
            other.lights.insert(other.lights.begin(), scene.lights.begin(), scene.lights.end());
            scene = std::move(other);
        }
    }
    scene.file = path;
    if (const json* camera = r.find("camera")) read_camera(Reader(source, *camera, "/camera"), scene.camera);
    each(source, r, "objects", [&](Reader object, const std::string& pointer) {
        scene.objects.push_back(read_object(source, std::move(object), pointer));
    });
    each(source, r, "lights",
         [&](Reader light, const std::string&) { scene.lights.push_back(read_light(std::move(light))); });
    r.vector("ambient", scene.ambient, 0, 1e4);
    r.vector("background", scene.background, 0, 1e4);
    if (const json* knobs = r.find("knobs")) {
        if (!knobs->is_object()) r.refuse("knobs", "must be an object { name: value }");
        for (const auto& [name, value] : knobs->items())
            scene.knobs[name] = value.is_string()    ? value.get<std::string>()
                                : value.is_boolean() ? (value.get<bool>() ? "on" : "off")
                                                     : value.dump();
    }
    r.done();
    sort_by_parent(source, scene.objects);
    return scene;
}

}  // namespace

SceneFile read_scene(const fs::path& path) {
    std::vector<fs::path> open_files;
    return read_included(path, open_files);
}

SceneFile parse_scene(const std::string& text, const fs::path& path) {
    std::vector<fs::path> open_files;
    return read(text, path, open_files);
}

fs::path find_asset(const fs::path& path) {
    for (const fs::path& candidate : {path, course_root() / "assets" / path, course_root() / path})
        if (fs::exists(candidate)) return candidate;
    throw InputError("no file " + path.string() + ", neither here nor below assets/");
}

glm::mat4 local_transform(const SceneObject& object) {
    glm::mat4 m = glm::translate(glm::mat4(1.0f), object.position);
    m = glm::rotate(m, glm::radians(object.rotation_deg.z), {0, 0, 1});
    m = glm::rotate(m, glm::radians(object.rotation_deg.y), {0, 1, 0});
    m = glm::rotate(m, glm::radians(object.rotation_deg.x), {1, 0, 0});
    return glm::scale(m, object.scale);
}

}  // namespace lightwalk
