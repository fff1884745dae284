// How a scene's environment is turned and scaled when it is read.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct EnvironmentScale {
    float cosine, sine;  // of the turn about +y, counter-clockwise seen from above
    float intensity;     // by what radiance and irradiance are multiplied
};

END_SHARED
