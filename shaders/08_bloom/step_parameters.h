// Parameters of one step of a blur.
#include <common/shared.h>

BEGIN_SHARED

struct StepParameters {
    ivec2 direction;  // of a line: (1, 0) or (0, 1)
    int first_tap;    // in taps[]: (offset in texels, weight), one side, the middle first
    int taps;
    vec2 extent;     // the picture's size in texels of `from`: of a level a fraction
    int from_apron;  // texels that `from` has before the picture's first, and after its last
    int apron;       // and the image that is written
    int mirrors;     // whether a level that is read is mirrored at the picture's border
    float spread;    // of Kawase's taps; of copy how many texels are read for one that is written
    float weight;    // image = weight * result + keep * image
    float keep;
};

END_SHARED
