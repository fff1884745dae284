// Shader data of the water around objects that stand in it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int RING_WAVES = 3;
const float RING_RATIO = 0.62f;  // from one ring wave's length to the next one's

struct WaterlineMap {
    vec2 corner;     // metres, world x and z of the map's first texel's corner
    float side_m;    // of the map
    float length_m;  // of the longest ring wave
    float slope;     // at the waterline
    float reach_m;
    float foam_m;
    int most_texels;  // distances beyond these are not looked for
    vec2 from_wind;   // x and z, unit length: where waves come from
    vec3 phase;       // radians, of each ring wave
};

END_SHARED
