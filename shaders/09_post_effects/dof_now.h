// Camera parameters of depth of field.
#include <common/shared.h>

BEGIN_SHARED

struct DofNow {
    float inverse_near, inverse_far;  // 1/m: depth to distance
    float focal_m, sensor_m;
    float height_px;  // of the whole picture
    float most_px;    // discs are no wider
    float wide_px;    // disc at infinite distance
    float reach;      // tiles to each side that a disc can reach
};

END_SHARED
