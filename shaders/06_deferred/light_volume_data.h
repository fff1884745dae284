// Light volume: a unit sphere or cone, transformed to the light's reach.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct LightVolumeData {
    mat4 to_world;
    uint light;  // index into the lights
};

END_SHARED
