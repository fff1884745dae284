// Solution of 05.cascade_split (F. Zhang et al., "Parallel-Split Shadow Maps for Large-Scale Virtual Environments",
// VRCIA 2006, section 3).
#include <cmath>

#include "05_shadow_maps/exercises.h"

namespace lightwalk::solution {

float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    if (i <= 0) return near_m;  // exact, regardless of rounding in powers
    if (i >= count) return far_m;
    const float t = static_cast<float>(i) / static_cast<float>(count);
    const float uniform = near_m + (far_m - near_m) * t;
    const float logarithmic = near_m * std::pow(far_m / near_m, t);
    return uniform + lambda * (logarithmic - uniform);
}

}  // namespace lightwalk::solution
