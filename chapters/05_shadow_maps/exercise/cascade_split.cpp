// Exercise 05.cascade_split: how what the camera sees is shared out among the cascades of a directional light.
// As it stands cascades are equally deep: next to the eye a texel is as wide as a house.
#include "05_shadow_maps/exercises.h"

namespace lightwalk::exercise {

// [cascade_split]
// The distance from the eye, in metres, at which cascade i of `count` ends; i from 0, which gives near_m, to `count`,
// which gives far_m, both exactly. 0 < near_m < far_m. With lambda = 0 all cascades are equally deep; with lambda = 1
// each is deeper than the one before by the same factor, so that all have texels of one size in the picture. In between
// the result is the mean of the two, weighted by lambda. It rises with i.
// [/cascade_split]
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    (void)lambda;
    return near_m + (far_m - near_m) * static_cast<float>(i) / static_cast<float>(count);
}

}  // namespace lightwalk::exercise
