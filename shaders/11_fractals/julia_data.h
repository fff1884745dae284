// Data for passes of a Julia set beside its knobs.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

struct JuliaNow {
    ViewRays rays;
    float pixel_rad;  // how wide a pixel is in the middle of the picture
    vec4 constant;    // c, at this time
    float bound;      // metres: the set lies in a ball of this radius
    vec3 to_light;    // unit length
    vec3 light;       // radiance times pi of a white surface that faces it: irradiance
    int tile;         // pixels along a side of the pre-pass's tiles
};

END_SHARED
