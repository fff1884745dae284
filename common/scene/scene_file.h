// Scene files: JSON that places models, a camera and lights. Every error names file, line and key.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/camera.h"
#include "common/scene/light.h"

namespace lightwalk {

/// Overrides of a model's materials. What is not given keeps what the model says.
struct MaterialOverride {
    std::optional<glm::vec3> diffuse, specular, emissive;  ///< linear
    std::optional<float> shininess, opacity, roughness, metalness;
    std::map<std::string, std::filesystem::path> maps;  ///< by slot, such as "normal" or "height"
};

struct SceneObject {
    std::string name, parent;      ///< parent: another object's name, or empty
    std::filesystem::path model;   ///< relative to assets/, or absolute; empty: a group
    glm::vec3 position{0.0f};      ///< metres
    glm::vec3 rotation_deg{0.0f};  ///< about x, then y, then z
    glm::vec3 scale{1.0f};
    MaterialOverride material;
};

struct SceneFile {
    std::filesystem::path file;
    Camera camera;
    std::vector<SceneObject> objects;  ///< a parent stands before its children
    std::vector<Light> lights;
    glm::vec3 ambient{0.05f};     ///< linear radiance from everywhere
    glm::vec3 background{0.02f};  ///< linear
    std::map<std::string, std::string> knobs;
};

/// Reads the file and those it includes. Throws InputError: syntax error, unknown key, wrong type, value out of range,
/// missing asset, a cycle of includes or parents.
SceneFile read_scene(const std::filesystem::path& path);
SceneFile parse_scene(const std::string& text, const std::filesystem::path& path);

/// Writes what read_scene reads back, whole or not at all.
void write_scene(const SceneFile& scene, const std::filesystem::path& path);

/// An asset's path: as given if it exists, else below assets/ or the root. Throws InputError where it is in none.
std::filesystem::path find_asset(const std::filesystem::path& path);

/// The object's transform into its parent's space.
glm::mat4 local_transform(const SceneObject& object);

}  // namespace lightwalk
