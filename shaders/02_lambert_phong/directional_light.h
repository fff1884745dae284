// Directional lights as shaders read them.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// [light]
struct DirectionalLight {
    vec3 to_light;  // unit length, world space
    vec3 radiance;  // linear: colour times intensity; a matt white surface that faces it shows just this
};
// [/light]

END_SHARED
