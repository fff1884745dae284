// Lines over the picture, for shaders and C++.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct MarkSegment {
    vec3 from;  // metres, world space
    float width_px;
    vec3 to;
    float alpha;
    vec3 color;  // linear
};

END_SHARED
