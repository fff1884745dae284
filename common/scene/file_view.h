// Cameras and lights of model files, placed in the world.
#pragma once
#include "common/scene/mesh.h"

namespace lightwalk {

/// `place`: node transform. `distance_m`: from camera to target.
Camera placed(const FileCamera& from, const glm::mat4& place, float distance_m);
Light placed(const FileLight& from, const glm::mat4& place);

}  // namespace lightwalk
