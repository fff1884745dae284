// Roles of a scene's objects and of a model's materials, for chapters that treat them specially.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace lightwalk {

enum class Role { plain, planet, ring, screen, skin, eye, cornea };

/// "planet, ring, screen, skin, eye, cornea"; `of_material`: only a material's roles.
std::string role_names(bool of_material = false);

/// The role of that name; Role::plain where there is none, or none that a material may have.
Role role_named(std::string_view name, bool of_material = false);

/// The word of a scene file; "" for Role::plain.
const char* name_of(Role role);

/// `role` of an object in a scene file: one for the object, or one for each material of its model that has one.
struct GivenRole {
    Role object = Role::plain;
    std::map<std::string, Role> materials;
    std::string where{};  ///< "file:line: key 'role'", for errors found when the model is loaded
    explicit operator bool() const { return object != Role::plain || !materials.empty(); }
};

struct SceneFile;

/// Who has which role in a scene. Names count only in a file in which nothing has a role: the objects "planet", "ring"
/// and "screen NAME", the materials "skin", "eye" and "cornea".
class Roles {
  public:
    /// `scene` must outlive it.
    explicit Roles(const SceneFile& scene);

    /// Of an object's part with that material.
    Role of(size_t object, const std::string& material) const;

    bool is_screen(size_t object) const;

    /// The object with the view that a screen shows: its `shows`, in a file without roles "camera NAME".
    std::string shown_by(size_t screen) const;

  private:
    const SceneFile& scene_;
    bool by_name_;
};

}  // namespace lightwalk
