// A sphere with a flat ring around it, as shaders read it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct RingedPlanet {
    vec3 center;         // of both, metres, world space
    float radius;        // of the sphere, metres; 0: there is none
    vec3 normal;         // of the ring's plane, unit length
    float inner, outer;  // radii of the ring, metres; both 0: there is none
};

END_SHARED
