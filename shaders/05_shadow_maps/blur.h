// Parameters of the blur of a layer of moments.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int WIDEST_BLUR = 16;

struct Blur {
    uint view;   // the view with these depths
    int radius;  // texels to each side, 0 to 16
    float exponent, exponent_negative;
    float weights[WIDEST_BLUR + 1];  // by the distance in texels; both sides and the middle sum to 1
};

END_SHARED
