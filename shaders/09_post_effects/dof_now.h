// What depth of field is told of the camera.
#include <common/shared.h>

BEGIN_SHARED

struct DofNow {
    float inverse_near, inverse_far;  // 1/m: depth to distance
    float focal_m, sensor_m;
    float height_px;  // of the whole picture
    float most_px;    // discs are no wider
    float wide_px;    // the disc of what is infinitely far
    float reach;      // tiles to each side that a disc can reach
};

END_SHARED
