// Roles of objects and materials that chapters treat specially.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace lightwalk {

enum class Role { plain, planet, ring, screen, skin, eye, cornea };

/// "planet, ring, screen, skin, eye, cornea"; `of_material`: only roles of materials.
std::string role_names(bool of_material = false);

/// Role::plain if the name is unknown, or is no role of materials if `of_material`.
Role role_named(std::string_view name, bool of_material = false);

/// Name in scene files; "" for Role::plain.
const char* name_of(Role role);

/// `role` of an object in a scene file: one role, or roles by material name.
struct GivenRole {
    Role object = Role::plain;
    std::map<std::string, Role> materials;
    std::string where{};  ///< "file:line: key 'role'", for errors found while loading the model
    explicit operator bool() const { return object != Role::plain || !materials.empty(); }
};

struct SceneFile;

/// Roles in a scene. Without any `role`, names decide: planet, ring, "screen NAME"; materials skin, eye, cornea.
class Roles {
  public:
    explicit Roles(const SceneFile& scene);

    Role of(size_t object, const std::string& material) const;

    bool is_screen(size_t object) const;

    /// Object whose view a screen shows: its `shows`, or "camera NAME" in files without roles.
    std::string shown_by(size_t screen) const;

  private:
    const SceneFile& scene_;
    bool by_name_;
};

}  // namespace lightwalk
