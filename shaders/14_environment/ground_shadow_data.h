// Where the ground is kept as a map, and from where light comes to it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct GroundShadowState {
    vec2 corner, extent;  // metres, world space: x and z of the map's first corner, and its size
    float ground_y;
    int directions;
};

// A direction that stands for a share of the light.
struct GroundLight {
    vec3 to_light;  // unit length, world space
    vec3 share;     // of all that arrives at the open ground, for each colour; they add up to 1
};

END_SHARED
