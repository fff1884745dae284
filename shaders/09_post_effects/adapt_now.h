// What adaptation is told.
#include <common/shared.h>

BEGIN_SHARED

struct AdaptNow {
    float share;  // of the way to what the picture asks for, in this frame: 1 is all of it
    uint valid;   // there was a frame before
};

END_SHARED
