#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/json_lines.h"
#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

using json = nlohmann::ordered_json;

json list(glm::vec3 v) { return {v.x, v.y, v.z}; }

json motion_json(const Motion& motion) {
    json j = json::object();
    if (motion.spin_deg_per_s != 0.0f) {
        j["spin_deg_per_s"] = motion.spin_deg_per_s;
        j["axis"] = list(motion.axis);
    }
    for (const Keyframe& key : motion.path)
        j["path"].push_back({{"time_s", key.time_s},
                             {"position", list(key.position)},
                             {"rotation_deg", list(key.rotation_deg)},
                             {"scale", list(key.scale)}});
    if (motion.period_s > 0.0f) j["period_s"] = motion.period_s;
    return j;
}

json object_json(const SceneObject& o) {
    json j = json::object();
    if (!o.name.empty()) j["name"] = o.name;
    if (!o.parent.empty()) j["parent"] = o.parent;
    if (o.role.object != Role::plain) j["role"] = name_of(o.role.object);
    for (const auto& [of_material, role] : o.role.materials) j["role"][of_material] = name_of(role);
    if (!o.shows.empty()) j["shows"] = o.shows;
    if (!o.model.empty()) j["model"] = o.model.generic_string();
    if (o.position != glm::vec3(0.0f)) j["position"] = list(o.position);
    if (o.rotation_deg != glm::vec3(0.0f)) j["rotation_deg"] = list(o.rotation_deg);
    if (o.scale != glm::vec3(1.0f)) j["scale"] = list(o.scale);
    json material = json::object();
    const MaterialOverride& m = o.material;
    if (m.diffuse) material["diffuse"] = list(*m.diffuse);
    if (m.specular) material["specular"] = list(*m.specular);
    if (m.emissive) material["emissive"] = list(*m.emissive);
    if (m.shininess) material["shininess"] = *m.shininess;
    if (m.opacity) material["opacity"] = *m.opacity;
    if (m.roughness) material["roughness"] = *m.roughness;
    if (m.metalness) material["metalness"] = *m.metalness;
    for (const auto& [slot, file] : m.maps) material["maps"][slot] = file.generic_string();
    if (m.blend) material["blend"] = *m.blend;
    if (!material.empty()) j["material"] = material;
    if (o.motion) j["motion"] = motion_json(o.motion);
    return j;
}

json light_json(const Light& light) {
    static constexpr const char* kinds[] = {"directional", "point", "spot"};
    json j{{"type", kinds[static_cast<int>(light.kind)]}, {"color", list(light.color)}, {"intensity", light.intensity}};
    if (light.kind != Light::Kind::point) j["direction"] = list(light.direction);
    if (light.kind != Light::Kind::directional) {
        j["position"] = list(light.position);
        j["range_m"] = light.range_m;
    }
    if (light.kind == Light::Kind::spot) {
        j["inner_deg"] = glm::degrees(light.inner_rad);
        j["outer_deg"] = glm::degrees(light.outer_rad);
        j["softness"] = light.softness;
    }
    if (light.shadow) j["shadow"] = true;
    if (light.size_m > 0.0f) j["size_m"] = light.size_m;
    if (light.size_rad > 0.0f) j["size_deg"] = glm::degrees(light.size_rad);
    return j;
}

json camera_json(const Camera& c) {
    return {{"position", list(c.position)},         {"target", list(c.target)}, {"up", list(c.up)},
            {"fov_deg", glm::degrees(c.fov_y_rad)}, {"near_m", c.near_m},       {"far_m", c.far_m}};
}

json knobs_json(const SceneFile& scene) {
    json j = json::object();
    for (const auto& [name, value] : scene.knobs) j[name] = value;
    return j;
}

void write(const json& j, const std::filesystem::path& path) {
    std::string text;
    try {
        text = j.dump(1, '\t');
    } catch (const json::type_error&) {
        throw InputError("{}: cannot be written: a name in the scene is not UTF-8, and JSON holds nothing else",
                         path.string());
    }
    write_file(path, text + "\n");
}

}  // namespace

void write_scene(const SceneFile& scene, const std::filesystem::path& path) {
    json j;
    j["camera"] = camera_json(scene.camera);
    j["ambient"] = list(scene.ambient);
    j["background"] = list(scene.background);
    if (const Environment& e = scene.environment)
        j["environment"] = {
            {"image", e.image.generic_string()}, {"intensity", e.intensity}, {"rotation_deg", e.rotation_deg}};
    if (scene.music) j["music"] = scene.music.file.generic_string();
    j["objects"] = json::array();
    for (const SceneObject& o : scene.objects) j["objects"].push_back(object_json(o));
    j["lights"] = json::array();
    for (const Light& light : scene.lights) j["lights"].push_back(light_json(light));
    j["knobs"] = knobs_json(scene);
    write(j, path);
}

void update_scene(const SceneFile& scene, const std::filesystem::path& path) {
    const std::string text = read_file(path);
    parse_json(text, path.string());  // throws and says where
    json j = json::parse(text);
    j["camera"] = camera_json(scene.camera);
    j["knobs"] = knobs_json(scene);
    write(j, path);
}

}  // namespace lightwalk
