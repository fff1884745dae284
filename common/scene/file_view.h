// Cameras and lights of a model's file, placed in the world.
#pragma once
#include "common/scene/mesh.h"

namespace lightwalk {

/// `place`: the transform of its node. `distance_m`: to the target.
Camera placed(const FileCamera& from, const glm::mat4& place, float distance_m);
Light placed(const FileLight& from, const glm::mat4& place);

}  // namespace lightwalk
