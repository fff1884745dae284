// The air between the eye and the scene, as the passes of 02.record_mist take it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct Mist {
    vec3 color;                       // linear: of mist without an end, and of the sky at the horizon
    float per_m;                      // 1/m; the transmittance of a metre is exp(-per_m)
    vec3 zenith;                      // linear: of the sky at the picture's upper edge
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
};

END_SHARED
