// What a vertex needs beside its normal so that a texture's directions are known in the world.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

// [tangent_frame]
struct TangentFrame {
    vec3 tangent;        // unit length, object space, perpendicular to the normal: where u grows
    float handedness;    // 1 or -1: v grows along handedness * cross(normal, tangent)
    vec2 metres_per_uv;  // object space: how far one step in u, and one in v, is on the surface
    float cos_uv;        // of the angle between the directions in which u and v grow: 0 where a texture is not sheared
};
// [/tangent_frame]

// [along_uv]
// A vector of tangent space in parts along the directions in which u and v grow, which need not be perpendicular to
// each other; z stays. What goes (x, y) that way changes u by x / metres_per_uv.x and v by y / metres_per_uv.y.
SHARED_FUNCTION vec3 along_uv(vec3 v, float cos_uv) {
    float sin_uv = sqrt(max(1.0f - cos_uv * cos_uv, 1e-4f));
    return vec3(v.x - v.y * cos_uv / sin_uv, v.y / sin_uv, v.z);
}
// [/along_uv]

END_SHARED
