#include "common/scene/role.h"

#include <algorithm>

#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

struct Named {
    const char* name;
    Role role;
    bool of_material;
};
constexpr Named known[] = {{"planet", Role::planet, false}, {"ring", Role::ring, false},
                           {"screen", Role::screen, false}, {"skin", Role::skin, true},
                           {"eye", Role::eye, true},        {"cornea", Role::cornea, true}};

constexpr std::string_view screen_prefix = "screen ";

}  // namespace

std::string role_names(bool of_material) {
    std::string names;
    for (const Named& one : known)
        if (one.of_material || !of_material) names += (names.empty() ? "" : ", ") + std::string(one.name);
    return names;
}

Role role_named(std::string_view name, bool of_material) {
    for (const Named& one : known)
        if (one.name == name && (one.of_material || !of_material)) return one.role;
    return Role::plain;
}

const char* name_of(Role role) {
    for (const Named& one : known)
        if (one.role == role) return one.name;
    return "";
}

Roles::Roles(const SceneFile& scene)
    : scene_(scene), by_name_(std::none_of(scene.objects.begin(), scene.objects.end(), [](const SceneObject& object) {
          return static_cast<bool>(object.role);
      })) {}

bool Roles::is_screen(size_t object) const {
    const SceneObject& o = scene_.objects[object];
    return by_name_ ? o.name.starts_with(screen_prefix) : o.role.object == Role::screen;
}

Role Roles::of(size_t object, const std::string& material) const {
    const SceneObject& o = scene_.objects[object];
    if (!by_name_) {
        const auto found = o.role.materials.find(material);
        return found == o.role.materials.end() ? o.role.object : found->second;
    }
    if (is_screen(object)) return Role::screen;
    return o.name == "planet" || o.name == "ring" ? role_named(o.name) : role_named(material, true);
}

std::string Roles::shown_by(size_t screen) const {
    const SceneObject& o = scene_.objects[screen];
    return by_name_ ? "camera " + o.name.substr(screen_prefix.size()) : o.shows;
}

}  // namespace lightwalk
