// Default scenes for models without a scene file.
#pragma once
#include <filesystem>
#include <string>

#include "common/scene/mesh.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// Scene with camera, lights and a background that matches add_ground()'s ground. `bounds` in metres.
SceneFile scene_of_model(const std::filesystem::path& model, const Bounds& bounds);

/// Adds the ground object below the scene's only model, unless the model is entirely unlit.
void add_ground(SceneFile& scene, const Model& model);

/// Ground mesh below a model, textured with the soft shadow of a uniform sky. `name`: file name in messages.
Model ground_below(const Model& model, const std::string& name);

/// Reason why no part of a model is visible from `eye`, such as "all of its materials are transparent"; "" if some is.
std::string why_invisible(const Model& model, glm::vec3 eye);

/// Cameras and lights of model files, placed in the world. `place`: node transform. `distance_m`: from camera to target.
Camera placed(const FileCamera& from, const glm::mat4& place, float distance_m);
Light placed(const FileLight& from, const glm::mat4& place);

/// Applies camera `number` of the model file, and its lights if any. Throws InputError without such a camera.
void use_camera_of_file(SceneFile& scene, const Model& model, size_t number);

}  // namespace lightwalk
