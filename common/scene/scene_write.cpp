#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/json_lines.h"
#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

using Json = nlohmann::ordered_json;

// Shortest decimal that reads back as the same float: 0.1f becomes 0.1, not 0.10000000149011612.
double number(float value) {
    char text[32];
    const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
    double result = 0;
    std::from_chars(text, end, result);
    return result;
}

// Degrees that read back as the same angle: both conversions round, so nearby floats are tried.
double degrees(float rad) {
    const float near = glm::degrees(rad);
    for (const float candidate : {near, std::nextafter(near, 0.0f), std::nextafter(near, 1e9f)})
        if (glm::radians(candidate) == rad) return number(candidate);
    return number(near);
}

Json list(glm::vec3 v) { return {number(v.x), number(v.y), number(v.z)}; }

Json motion_json(const Motion& motion) {
    Json j = Json::object();
    if (motion.spin_deg_per_s != 0.0f) {
        j["spin_deg_per_s"] = number(motion.spin_deg_per_s);
        j["axis"] = list(motion.axis);
    }
    for (const Keyframe& key : motion.path)
        j["path"].push_back({{"time_s", number(key.time_s)},
                             {"position", list(key.position)},
                             {"rotation_deg", list(key.rotation_deg)},
                             {"scale", list(key.scale)}});
    if (motion.period_s > 0.0f) j["period_s"] = number(motion.period_s);
    return j;
}

Json object_json(const SceneObject& o) {
    Json j = Json::object();
    if (!o.name.empty()) j["name"] = o.name;
    if (!o.parent.empty()) j["parent"] = o.parent;
    if (o.role.object != Role::plain) j["role"] = name_of(o.role.object);
    for (const auto& [of_material, role] : o.role.materials) j["role"][of_material] = name_of(role);
    if (!o.shows.empty()) j["shows"] = o.shows;
    if (!o.model.empty()) j["model"] = o.model.generic_string();
    if (o.ground) j["ground"] = true;
    if (o.position != glm::vec3(0.0f)) j["position"] = list(o.position);
    if (o.rotation_deg != glm::vec3(0.0f)) j["rotation_deg"] = list(o.rotation_deg);
    if (o.scale != glm::vec3(1.0f)) j["scale"] = list(o.scale);
    Json material = Json::object();
    const MaterialOverride& m = o.material;
    if (m.diffuse) material["diffuse"] = list(*m.diffuse);
    if (m.specular) material["specular"] = list(*m.specular);
    if (m.emissive) material["emissive"] = list(*m.emissive);
    if (m.shininess) material["shininess"] = number(*m.shininess);
    if (m.opacity) material["opacity"] = number(*m.opacity);
    if (m.transmission) material["transmission"] = list(*m.transmission);
    if (m.roughness) material["roughness"] = number(*m.roughness);
    if (m.metalness) material["metalness"] = number(*m.metalness);
    for (const auto& [slot, file] : m.maps) material["maps"][slot] = file.generic_string();
    if (m.blend) material["blend"] = *m.blend;
    if (m.two_sided) material["two_sided"] = *m.two_sided;
    if (!material.empty()) j["material"] = material;
    if (o.hidden) j["hidden"] = true;
    if (o.locked) j["locked"] = true;
    if (o.motion) j["motion"] = motion_json(o.motion);
    return j;
}

Json light_json(const Light& light) {
    static constexpr const char* kinds[] = {"directional", "point", "spot"};
    Json j = Json::object();
    if (!light.name.empty()) j["name"] = light.name;
    j.update({{"type", kinds[static_cast<int>(light.kind)]},
              {"color", list(light.color)},
              {"intensity", number(light.intensity)}});
    if (light.kind != Light::Kind::point) j["direction"] = list(light.direction);
    if (light.kind != Light::Kind::directional) {
        j["position"] = list(light.position);
        j["range_m"] = number(light.range_m);
    }
    if (light.kind == Light::Kind::spot) {
        j["inner_deg"] = degrees(light.inner_rad);
        j["outer_deg"] = degrees(light.outer_rad);
        j["softness"] = number(light.softness);
    }
    if (light.shadow) j["shadow"] = true;
    if (light.locked) j["locked"] = true;
    if (light.size_m > 0.0f) j["size_m"] = number(light.size_m);
    if (light.tube_m != glm::vec3(0.0f)) j["tube_m"] = list(light.tube_m);
    if (light.size_rad > 0.0f) j["size_deg"] = degrees(light.size_rad);
    return j;
}

Json camera_json(const Camera& c) {
    return {{"position", list(c.position)},    {"target", list(c.target)},   {"up", list(c.up)},
            {"fov_deg", degrees(c.fov_y_rad)}, {"near_m", number(c.near_m)}, {"far_m", number(c.far_m)}};
}

Json knobs_json(const SceneFile& scene) {
    Json j = Json::object();
    for (const auto& [name, value] : scene.knobs) j[name] = value;
    return j;
}

std::string text_of(const Json& j) {
    try {
        return j.dump(1, '\t') + "\n";
    } catch (const Json::type_error&) {
        throw InputError("a name in the scene is not UTF-8, and JSON holds nothing else");
    }
}

void write(const Json& j, const std::filesystem::path& path) {
    std::string text;
    try {
        text = text_of(j);
    } catch (const InputError& e) { throw InputError("{}: cannot be written: {}", path.string(), e.what()); }
    write_file(path, text);
}

Json lights_json(const SceneFile& scene) {
    Json all = Json::array();
    auto hidden = scene.hidden_lights.begin();
    for (size_t i = 0; i <= scene.lights.size(); ++i) {
        for (; hidden != scene.hidden_lights.end() && (hidden->before <= i || i == scene.lights.size()); ++hidden) {
            all.push_back(light_json(hidden->light));
            all.back()["hidden"] = true;
        }
        if (i < scene.lights.size()) all.push_back(light_json(scene.lights[i]));
    }
    return all;
}

Json scene_json(const SceneFile& scene, const std::vector<std::string>& includes) {
    Json j;
    if (!includes.empty()) j["include"] = includes;
    j["camera"] = camera_json(scene.camera);
    j["ambient"] = list(scene.ambient);
    j["background"] = list(scene.background);
    if (const Environment& e = scene.environment)
        j["environment"] = {{"image", e.image.generic_string()},
                            {"intensity", number(e.intensity)},
                            {"rotation_deg", number(e.rotation_deg)}};
    if (scene.music) j["music"] = scene.music.file.generic_string();
    j["objects"] = Json::array();
    for (const SceneObject& o : scene.objects) j["objects"].push_back(object_json(o));
    j["lights"] = lights_json(scene);
    if (scene.bare) j["bare"] = true;
    if (scene.emission != 1.0f) j["emission"] = number(scene.emission);
    if (!scene.knobs_of.empty()) j["knobs_of"] = scene.knobs_of;
    j["knobs"] = knobs_json(scene);
    return j;
}

}  // namespace

std::string scene_text(const SceneFile& scene, const std::vector<std::string>& includes) {
    return text_of(scene_json(scene, includes));
}

void write_scene(const SceneFile& scene, const std::filesystem::path& path) { write(scene_json(scene, {}), path); }

void update_scene(const SceneFile& scene, const std::filesystem::path& path) {
    const std::string text = read_file(path);
    parse_json(text, path.string());
    Json j = Json::parse(text);
    j["camera"] = camera_json(scene.camera);
    j["knobs"] = knobs_json(scene);
    write(j, path);
}

}  // namespace lightwalk
