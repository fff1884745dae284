// Shader data of image-based light.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct ImageLightState {
    vec3 box_lower;  // metres, world space: the room around a probe
    uint has_box;    // 1: lookups are corrected for where the surface stands in it
    vec3 box_upper;
    float levels;     // of the prefiltered cube; the last has roughness 1
    vec3 box_center;  // where the cube was drawn from
    float texels;     // of a face's side, level 0
};

END_SHARED
