// right
#include <cmath>

#include "05_shadow_maps/exercises.h"
namespace lightwalk::exercise {
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    if (i == 0 || i == count) return i == 0 ? near_m : far_m;
    const double n = near_m, f = far_m, t = double(i) / count, l = lambda;
    return static_cast<float>(l * n * std::pow(f / n, t) + (1 - l) * (n + t * (f - n)));
}
}  // namespace lightwalk::exercise
