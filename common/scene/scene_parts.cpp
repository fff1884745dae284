#include <glm/gtc/matrix_transform.hpp>

#include "common/image/image.h"
#include "common/scene/scene_reader.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

fs::path asset(const JsonWithLines& source, const std::string& pointer, const std::string& name) {
    try {
        find_asset(name);
    } catch (const InputError& e) { throw InputError("{}: {}", source.where(pointer), e.what()); }
    return name;
}

}  // namespace

void read_camera(KeyReader r, Camera& camera) {
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

namespace {

MaterialOverride read_material(const JsonWithLines& source, KeyReader r) {
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
    color("transmission", material.transmission, 1);
    number("shininess", material.shininess, 0, 1e5);
    number("opacity", material.opacity, 0, 1);
    number("roughness", material.roughness, 0, 1);
    number("metalness", material.metalness, 0, 1);
    if (bool both = false; r.find("two_sided")) {
        r.boolean("two_sided", both);
        material.two_sided = both;
    }
    if (bool blend = false; r.find("blend")) {
        r.boolean("blend", blend);
        material.blend = blend;
    }
    if (const json* maps = r.find("maps")) {
        if (!maps->is_object()) r.refuse("maps", "must be an object { slot: file }");
        for (const auto& [slot, file] : maps->items()) {
            const std::string pointer = r.at("maps") + "/" + pointer_step(slot);
            if (!file.is_string()) throw InputError("{} must be a file name in quotes", source.where(pointer));
            material.maps[slot] = asset(source, pointer, file.get<std::string>());
        }
    }
    r.done();
    return material;
}

void read_scale(KeyReader& r, glm::vec3& scale) {
    if (const json* given = r.find("scale"); given && given->is_number()) {
        float s = 1;
        r.number("scale", s, -1e6, 1e6);
        scale = glm::vec3(s);
    } else {
        r.vector("scale", scale, -1e6, 1e6);
    }
    for (int i = 0; i < 3; ++i)
        if (scale[i] == 0.0f) r.refuse("scale", "is 0: nothing would be left of the object");
}

void read_keyframe(KeyReader r, const SceneObject& object, std::vector<Keyframe>& path) {
    Keyframe key{0, object.position, object.rotation_deg, object.scale};
    if (!r.find("time_s")) r.refuse("time_s", "is missing: every keyframe needs its time");
    r.number("time_s", key.time_s, -1e6, 1e6);
    r.vector("position", key.position);
    r.vector("rotation_deg", key.rotation_deg, -1e6, 1e6);
    read_scale(r, key.scale);
    r.done();
    if (!path.empty() && key.time_s <= path.back().time_s) r.refuse("time_s", "must be above the one before it");
    if (!path.empty() && glm::sign(key.scale) != glm::sign(path.back().scale))
        r.refuse("scale", "has another sign than the keyframe before: on the way nothing would be left of the object");
    path.push_back(key);
}

Motion read_motion(const JsonWithLines& source, KeyReader r, const SceneObject& object) {
    Motion motion;
    r.number("spin_deg_per_s", motion.spin_deg_per_s, -1e5, 1e5);
    r.vector("axis", motion.axis, -1e6, 1e6);
    if (glm::length(motion.axis) == 0.0f) r.refuse("axis", "has no length");
    each(source, r, "path",
         [&](KeyReader key, const std::string&) { read_keyframe(std::move(key), object, motion.path); });
    if (r.find("path") && motion.path.empty()) r.refuse("path", "is empty: it needs a keyframe { }");
    if (r.find("period_s")) {
        r.number("period_s", motion.period_s, 0, 1e6);
        if (motion.path.empty()) r.refuse("period_s", "closes a path, and there is none");
        if (motion.period_s <= motion.path.back().time_s - motion.path.front().time_s)
            r.refuse("period_s", "must be above the time from the first keyframe to the last");
    }
    r.done();
    return motion;
}

Role read_role(const JsonWithLines& source, const json& given, const std::string& pointer, bool of_material) {
    if (!given.is_string())
        throw InputError("{} must be a role in quotes: {}", source.where(pointer), role_names(of_material));
    const Role role = role_named(given.get<std::string>(), of_material);
    if (role == Role::plain)
        throw InputError("{} is '{}', expected {}", source.where(pointer), given.get<std::string>(),
                         role_names(of_material));
    return role;
}

void read_roles(const JsonWithLines& source, KeyReader& r, SceneObject& object) {
    r.string("shows", object.shows);
    if (const json* role = r.find("role")) {
        const std::string pointer = r.at("role");
        object.role.where = source.where(pointer);
        if (object.model.empty()) r.refuse("role", "is of an object without a model: nothing would have it");
        if (!role->is_object())
            object.role.object = read_role(source, *role, pointer, false);
        else
            for (const auto& [material, name] : role->items())
                object.role.materials[material] = read_role(source, name, pointer + "/" + pointer_step(material), true);
        if (!object.role) r.refuse("role", "names no material: expected { material: role }");
    }
    if (object.role.object == Role::screen && object.shows.empty())
        r.refuse("shows", "is missing: the name of the object whose view the screen shows");
    if (object.role.object != Role::screen && r.find("shows"))
        r.refuse("shows", "is of an object that is not a screen; write \"role\": \"screen\"");
}

}  // namespace

SceneObject read_object(const JsonWithLines& source, KeyReader r, const std::string& pointer) {
    SceneObject object;
    std::string model;
    r.string("name", object.name);
    r.string("parent", object.parent);
    r.string("model", model);
    if (!model.empty()) object.model = asset(source, pointer + "/model", model);
    r.boolean("ground", object.ground);
    if (object.ground && model.empty())
        r.refuse("ground", "is of an object without a model: nothing would be above it");
    read_roles(source, r, object);
    r.boolean("hidden", object.hidden);
    r.boolean("locked", object.locked);
    r.vector("position", object.position);
    r.vector("rotation_deg", object.rotation_deg);
    read_scale(r, object.scale);
    if (const json* material = r.find("material"))
        object.material = read_material(source, KeyReader(source, *material, pointer + "/material"));
    if (const json* motion = r.find("motion")) {
        object.motion = read_motion(source, KeyReader(source, *motion, pointer + "/motion"), object);
        if (!motion->contains("spin_deg_per_s") && !motion->contains("path"))
            r.refuse("motion", "says neither spin_deg_per_s nor path");
    }
    r.done();
    return object;
}

Light read_light(KeyReader r, bool& hidden) {
    Light light;
    r.boolean("hidden", hidden);
    std::string kind = "directional";
    r.string("type", kind);
    if (kind == "point")
        light.kind = Light::Kind::point;
    else if (kind == "spot")
        light.kind = Light::Kind::spot;
    else if (kind != "directional")
        r.refuse("type", fmt::format("is '{}', expected directional, point or spot", kind));
    r.vector("color", light.color, 0, 1);
    r.number("intensity", light.intensity, 0, 1e6);
    if (light.kind != Light::Kind::point) {
        r.vector("direction", light.direction);
        if (glm::length(light.direction) == 0.0f) r.refuse("direction", "has no length");
        // Unit vectors stay bit-identical, so that written scenes round-trip.
        if (std::abs(glm::length(light.direction) - 1.0f) > 1e-6f) light.direction = glm::normalize(light.direction);
    }
    if (light.kind != Light::Kind::directional) {
        r.vector("position", light.position);
        r.number("range_m", light.range_m, 0, 1e6);
    }
    if (light.kind == Light::Kind::spot) {
        r.angle("inner_deg", light.inner_rad, 0, 180);
        r.angle("outer_deg", light.outer_rad, 0, 180);
        r.number("softness", light.softness, -2, 1);
        if (light.inner_rad > light.outer_rad) r.refuse("inner_deg", "is above outer_deg");
    }
    r.string("name", light.name);
    r.boolean("shadow", light.shadow);
    r.boolean("locked", light.locked);
    if (light.kind == Light::Kind::directional)
        r.angle("size_deg", light.size_rad, 0, 90);
    else
        r.number("size_m", light.size_m, 0, 1e3);
    if (light.kind == Light::Kind::point) r.vector("tube_m", light.tube_m, -1e3, 1e3);
    r.done();
    return light;
}

Environment read_environment(const JsonWithLines& source, KeyReader& scene) {
    Environment environment;
    std::string image, pointer = scene.at("environment");
    if (const json* given = scene.find("environment"); given->is_string()) {
        image = given->get<std::string>();
    } else {
        KeyReader r(source, *given, pointer);
        if (!r.find("image")) r.refuse("image", "is missing: the name of an .hdr file");
        r.string("image", image);
        r.number("intensity", environment.intensity, 0, 1e6);
        r.number("rotation_deg", environment.rotation_deg, -1e6, 1e6);
        r.done();
        pointer += "/image";
    }
    environment.where = source.where(pointer);
    if (!is_hdr_name(image)) throw InputError("{} is '{}', expected an .hdr or .pfm file", environment.where, image);
    environment.image = asset(source, pointer, image);
    return environment;
}

SceneMusic read_music(const JsonWithLines& source, KeyReader& scene) {
    const std::string pointer = scene.at("music");
    std::string file;
    scene.string("music", file);
    if (file.empty()) scene.refuse("music", "is empty: the name of an Ogg Vorbis file");
    return {.file = asset(source, pointer, file), .where = source.where(pointer)};
}

}  // namespace lightwalk
