// What the blur of a layer of moments needs to know.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int WIDEST_BLUR = 16;

struct Blur {
    uint view;   // whose depths these are
    int radius;  // texels to each side, 0 to 16
    float exponent, exponent_negative;
    float weights[WIDEST_BLUR + 1];  // by the distance in texels; those of both sides and the middle sum to 1
};

END_SHARED
