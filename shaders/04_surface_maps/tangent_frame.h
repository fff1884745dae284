// What a vertex needs beside its normal so that a texture's directions are known in the world.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

// [tangent_frame]
struct TangentFrame {
    vec3 tangent;        // unit length, object space, perpendicular to the normal: where u grows
    float handedness;    // 1 or -1: v grows along handedness * cross(normal, tangent)
    vec2 metres_per_uv;  // object space: how far one step in u, and one in v, is on the surface
};
// [/tangent_frame]

END_SHARED
