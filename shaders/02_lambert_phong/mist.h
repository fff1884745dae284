// Mist parameters of 02.record_mist.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct Mist {
    vec3 color;                       // linear: infinitely deep mist, and the sky at the horizon
    float per_m;                      // extinction, 1/m: transmittance over a metre is exp(-per_m)
    vec3 zenith;                      // linear: sky at the picture's upper edge
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
};

END_SHARED
