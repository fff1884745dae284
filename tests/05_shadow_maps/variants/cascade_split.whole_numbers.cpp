// wrong: cascade_split
#include <cmath>

#include "05_shadow_maps/exercises.h"
namespace lightwalk::exercise {
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    if (i == 0 || i == count) return i == 0 ? near_m : far_m;
    const float t = float(i / count);
    return lambda * near_m * std::pow(far_m / near_m, t) + (1 - lambda) * (near_m + t * (far_m - near_m));
}
}  // namespace lightwalk::exercise
