// Lights of every kind as shaders read them, in one buffer.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

const uint LIGHT_DIRECTIONAL = 0u;
const uint LIGHT_POINT = 1u;
const uint LIGHT_SPOT = 2u;

// [light]
struct LightData {
    vec3 position;    // metres, world space; point and spot
    float range;      // metres: beyond it a ranged falloff is 0; point and spot
    vec3 direction;   // unit length, world space, the way the light travels; directional and spot
    uint kind;        // LIGHT_...
    vec3 radiance;    // linear: colour times intensity, at the surface (directional) or at 1 m
    float softness;   // of a spot's cone, 0 to 1
    float cos_inner;  // of the half angles of a spot's cone; cos_inner >= cos_outer
    float cos_outer;
};
// [/light]

// [influence_radius]
// How far a point or spot light is taken to reach, in metres: its range or, with a threshold above 0, the distance at
// which an inverse square that never ends has fallen to that radiance.
SHARED_FUNCTION float influence_radius(LightData light, float threshold) {
    float brightest = max(light.radiance.x, max(light.radiance.y, light.radiance.z));
    return threshold > 0.0f ? sqrt(brightest / threshold) : light.range;
}
// [/influence_radius]

END_SHARED
