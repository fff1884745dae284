// The C++ exercise of this chapter. The name calls the student's version or the reference, as the toggle says.
#pragma once
#include "common/base/exercise.h"
#include "common/scene/light.h"
#include "common/scene/mesh.h"

namespace lightwalk {

// [light_reaches_box]
/// Whether a light that reaches `radius_m` far (0 or more) may light something in `box` (world space, not empty). Never
/// false where it does. A directional light always does, a radius of 0 never. A point light does where the box's
/// nearest point is within the radius. A spot light, besides, only where its cone of half angle outer_rad (0 to pi)
/// meets the ball around the box. A thousandth of the radius to the safe side is allowed everywhere.
EXERCISE("03.light_reaches_box", bool, light_reaches_box, const Light& light, float radius_m, const Bounds& box);
// [/light_reaches_box]

}  // namespace lightwalk
