// Parameters of the effects beside the knobs.
#include <common/shared.h>

BEGIN_SHARED

struct PostNow {
    mat3 white;        // from linear Rec. 709 to the same under another white
    mat3 kernel;       // kernel[row][column], row 0 above the pixel
    vec2 mouse;        // 0 to 1 over the picture, from its upper left corner
    vec2 whole;        // pixels of the whole picture, of which this may be a part
    vec2 origin;       // of this part in it, pixels
    float tone_gain;   // before the tone curve
    float scan_phase;  // turns, 0 to 1
    uint grain_frame;  // which picture of the film
    uint shown_frame;  // another one for each picture shown
    uint zero;         // 0
};

END_SHARED
