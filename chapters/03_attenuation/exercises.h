// C++ exercise of this chapter. The name calls the student's version or the reference, as the switch says.
#pragma once
#include "common/base/exercise.h"
#include "common/scene/light.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// Specification: exercise/light_reaches_box.cpp.
EXERCISE("03.light_reaches_box", bool, light_reaches_box, const Light& light, float radius_m, const Bounds& box);

}  // namespace lightwalk
