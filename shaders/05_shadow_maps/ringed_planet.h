// Shader data of a sphere with a flat ring.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct RingedPlanet {
    vec3 center;         // common centre, metres, world space
    float radius;        // radius of the sphere, metres; 0: none
    vec3 normal;         // normal of the ring's plane, unit length
    float inner, outer;  // radii of the ring, metres; both 0: none
};

END_SHARED
