// Parameters of view_image.comp.
#include <common/shared.h>

BEGIN_SHARED

const int LOOK_LINEAR = 0;   // linear light: scaled, then sRGB-encoded
const int LOOK_ENCODED = 1;  // codes as they are
const int LOOK_DEPTH = 2;    // reversed depth of a perspective camera: near is bright
const int LOOK_NUMBER = 3;   // one number, scaled

struct LookParameters {
    vec2 image_size;  // texels
    float scale;
    int kind;     // LOOK_...
    int channel;  // 0: all; 1 to 4: red, green, blue, alpha
    int layers;
    float near_m;  // near plane of the camera
    float far_m;
    float bright_m;  // distance shown as white; dark_m is nearly black
    float dark_m;
    uvec2 corner;  // rectangle's corner in the result, pixels
    uvec2 size;    // rectangle's size, pixels
};

END_SHARED
