// The box around an item, for shaders and C++.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct ItemBox {
    vec3 lower, upper;  // metres, world space
};

END_SHARED
