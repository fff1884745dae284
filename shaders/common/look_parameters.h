// How view_image.comp shows an image.
#include <common/shared.h>

BEGIN_SHARED

const int LOOK_LINEAR = 0;   // linear light: scaled, then sRGB-encoded
const int LOOK_ENCODED = 1;  // codes as they are
const int LOOK_DEPTH = 2;    // reversed depth of a perspective camera: near is bright
const int LOOK_NUMBER = 3;   // one number: scaled, shown as it is

struct LookParameters {
    vec2 image_size;  // texels
    float scale;
    int kind;     // LOOK_...
    int channel;  // 0 all, 1 to 4 one of red, green, blue, alpha
    int layers;
    float near_m;  // the planes of the camera
    float far_m;
    float bright_m;  // at this distance depth is shown white, at dark_m nearly black
    float dark_m;
    uvec2 corner;  // of the rectangle that shows it, in pixels of the result
    uvec2 size;    // of the rectangle
};

END_SHARED
