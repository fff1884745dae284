// Shader data of directional lights.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// [light]
struct DirectionalLight {
    vec3 to_light;  // unit length, world space
    vec3 radiance;  // linear: colour times intensity; the radiance of a white Lambertian surface facing the light
};
// [/light]

END_SHARED
