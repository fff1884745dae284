// How show_image.comp shows an image.
#include <common/shared.h>

BEGIN_SHARED

struct ImageShown {
    vec2 first;  // texels: where the part that is shown begins
    vec2 extent;
    vec2 place;  // pixels of the picture: where it is put
    vec2 size;
    vec3 gain;
    float around;  // grey light, added everywhere
    int gate;      // of words: nothing is shown where this one is 0
};

END_SHARED
