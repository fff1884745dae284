// Data for the passes of the sky.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

struct StarsNow {
    ViewRays rays;
    mat3 to_galaxy;    // from the view's axes to the star map's
    mat3 to_view;      // from the world's axes to the view's
    vec2 size;         // pixels
    float sigma_px;    // standard deviation of a star's image
    float brightness;  // radiance in the middle of a star of magnitude 0
    float milky_way;
};

END_SHARED
