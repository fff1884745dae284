// wrong: transmittance(
#include "12_skin/profile.h"
vec3 transmittance(float thickness_mm) {
    float s = thickness_mm;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 6u; ++i) sum += skin_weight[i] * exp(-s * s / skin_variance_mm2[i]);
    return sum;
}
