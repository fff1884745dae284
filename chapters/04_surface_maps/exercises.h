// The C++ exercise of this chapter. The name calls the student's version or the reference, as the toggle says.
#pragma once
#include "04_surface_maps/tangent_frame.h"
#include "common/base/exercise.h"
#include "common/structs.h"

namespace lightwalk {

// [tangent_frame]
/// The frame at corner `a` of the triangle a, b, c. `tangent` has unit length, is perpendicular to a.normal (of unit
/// length) and points where u grows; `handedness` is 1, or -1 where the texture is mirrored; `metres_per_uv` are the
/// lengths of dP/du and dP/dv. Where the texture coordinates span no area, or the triangle none, there are no such
/// directions: then the tangent is any unit vector perpendicular to the normal, the handedness 1 and metres_per_uv 0.
EXERCISE("04.tangent_frame", TangentFrame, tangent_frame, const Vertex& a, const Vertex& b, const Vertex& c);
// [/tangent_frame]

}  // namespace lightwalk
