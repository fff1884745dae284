// C++ exercise of this chapter. The name calls the student's version or the reference, as the switch says.
#pragma once
#include "common/base/exercise.h"
#include "common/scene/light.h"

namespace lightwalk {

/// Of a unit sphere around the origin, or of a unit cone: its apex at the origin, its base of radius 1 at z = 1.
struct LightVolume {
    enum class Shape { sphere, cone };
    Shape shape = Shape::sphere;
    glm::mat4 to_world{1.0f};
};

/// Specification: exercise/light_volume_bounds.cpp.
EXERCISE("06.light_volume_bounds", LightVolume, light_volume_bounds, const Light& light, float radius_m);

}  // namespace lightwalk
