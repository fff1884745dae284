// Display of the surroundings behind the scene.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct BackdropNow {
    float ground_y;  // metres, world space
    float camera_m;  // above the ground, when the picture was taken
    float radius_m;  // of the ground that the picture is projected on
    uint has_ground;
    float level;                  // of the picture: 0 is sharp
    vec2 map_corner, map_extent;  // metres: x and z of the map of light that arrives at the ground
};

END_SHARED
