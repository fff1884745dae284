// wrong: cascade_split
#include <cmath>

#include "05_shadow_maps/exercises.h"
namespace lightwalk::exercise {
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    const float t = float(i) / float(count);
    return lambda * near_m * std::pow(far_m / near_m, t) + (1 - lambda) * far_m * t;
}
}  // namespace lightwalk::exercise
