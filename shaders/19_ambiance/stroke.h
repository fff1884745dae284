// A straight stroke of a pen, in heights of a capital letter.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct Stroke {
    vec2 from, to;
};

END_SHARED
