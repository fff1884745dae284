// How the surroundings are shown behind what stands in them.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

struct BackdropNow {
    float ground_y;   // metres, world space
    float camera_m;   // above the ground, when the picture was taken
    uint has_ground;
    float level;      // of the picture: 0 is sharp
};

END_SHARED
