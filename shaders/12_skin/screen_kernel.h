// A blur over the picture.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct ScreenBlur {
    ivec2 direction;
    int taps;
    float pixels_at_1m;  // that a metre is wide at a distance of 1 m
    float edge_mm;       // surfaces so far apart in depth give each other nothing
};

END_SHARED
