// What one step of a blur is told.
#include "common/shared.h"

BEGIN_SHARED

struct StepParameters {
    ivec2 direction;  // of a line: (1, 0) or (0, 1)
    int first_tap;    // in taps[]: (offset in texels, weight), one side, the middle first
    int taps;
    float spread;  // of Kawase's taps
    float weight;  // the image becomes weight * what was found + keep * what it held
    float keep;
};

END_SHARED
