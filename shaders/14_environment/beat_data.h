// A sphere that music moves: where it is, and how far which levels move it at this moment.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct BeatNow {
    vec3 center;       // metres, world space
    float radius_m;    // of the sphere at rest
    vec3 heights;      // of the low, middle and high waves: shares of the radius, times their levels
    float brightness;  // height of a doubling of the surroundings' radiance, a share of the radius
    float blur;        // level of the surroundings' cube used for brightness
    vec3 frequencies;  // of each band's waves, radians along a radius
    float glow;        // radiance in the deepest valleys
    mat3 from_world;   // into the space of the waves
};

END_SHARED
