// Picture data for fragments of transparent surfaces, and the entry of a list.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct TransparencyNow {
    float near_m, far_m;   // of transparent surfaces along the view: the moments' depth runs from -1 there to 1
    uint width;            // pixels
    uint capacity;         // fragments in the lists
    float moment_bias;     // 0 to 1
    float overestimation;  // 0 to 1
};

// 20 bytes, and 4 for each pixel's head.
struct ListedFragment {
    uint red_green, blue_alpha;  // half floats
    uint tint;                   // roots of the shares by channel, 10 bits each
    float depth;                 // reversed
    uint next;                   // place in the buffer plus 1; 0: the last one
};

END_SHARED
