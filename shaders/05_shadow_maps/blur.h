// Blur parameters for a layer of moments.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int WIDEST_BLUR = 16;

struct Blur {
    uint view;   // index of the depths' view
    int radius;  // texels to each side, 0 to 16
    float exponent, exponent_negative;
    float weights[WIDEST_BLUR + 1];  // by distance in texels; centre and both sides sum to 1
};

END_SHARED
