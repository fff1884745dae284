// Geometry of a light volume: a unit sphere, or a unit cone, moved to the light's reach.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct LightVolumeData {
    mat4 to_world;
    uint light;  // of the lights' buffer
};

END_SHARED
