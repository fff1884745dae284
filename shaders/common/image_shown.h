// Parameters of show_image.comp.
#include <common/shared.h>

BEGIN_SHARED

struct ImageShown {
    vec2 first;  // upper left corner of the visible part, texels
    vec2 extent;
    vec2 place;  // its position in the picture, pixels
    vec2 size;
    vec3 gain;
    float around;  // grey light, added everywhere
    int gate;      // index of a word that hides the image if it is 0
};

END_SHARED
