// Parameters of the example of docs/framework.md, in C++ and GLSL.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// [tint_struct]
struct Pigment {
    vec3 color;
    float share;  // 0 to 1
};
// [/tint_struct]

END_SHARED
