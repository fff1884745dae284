// Parameters of the adaptation.
#include <common/shared.h>

BEGIN_SHARED

struct AdaptNow {
    float share;  // share of the difference to the target in this frame, up to 1
    uint valid;   // there was a frame before
};

END_SHARED
