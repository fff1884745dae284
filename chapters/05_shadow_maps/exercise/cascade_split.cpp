// Exercise 05.cascade_split: the distances at which the cascades of a directional light end.
// Starter: all cascades are equally deep: next to the camera a texel is as wide as a house.
#include "05_shadow_maps/exercises.h"

namespace lightwalk::exercise {

// [cascade_split]
// The distance from the camera, in metres, at which cascade i of `count` ends. i = 0 gives
// near_m and i = `count` gives far_m, both exactly; 0 < near_m < far_m. With lambda = 0 all
// cascades are equally deep. With lambda = 1 each is deeper than the one before by a
// constant factor, so that all have texels of the same size on the screen. In between, the
// result is the weighted mean of the distances for 0 and for 1, with weight lambda for the
// latter. It increases with i.
// [/cascade_split]
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    (void)lambda;
    return near_m + (far_m - near_m) * static_cast<float>(i) / static_cast<float>(count);
}

}  // namespace lightwalk::exercise
