// A scene for a model that comes without one.
#pragma once
#include <filesystem>
#include <string>

#include "common/scene/mesh.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// A scene that shows one model: a camera that frames it, a key and a fill light, light from everywhere, and behind it
/// the colour that a ground of add_ground() has in this light. `bounds` in metres.
SceneFile scene_of_model(const std::filesystem::path& model, const Bounds& bounds);

/// Adds the ground below the scene's only model; not where nothing of the model is lit.
void add_ground(SceneFile& scene, const Model& model);

/// The ground below a model, with the soft shadow of a sky above. `name` stands for its file in messages.
Model ground_below(const Model& model, const std::string& name);

/// Why nothing of a model is seen from `eye`: "all of its materials are transparent"; "" where something is.
std::string why_invisible(const Model& model, glm::vec3 eye);

/// The camera of that number in the model's file, and the file's lights instead of the scene's where it has any. Throws
/// InputError if there is no such camera.
void use_camera_of_file(SceneFile& scene, const Model& model, size_t number);

}  // namespace lightwalk
