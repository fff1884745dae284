// Solution of 12.transmittance.
#include "12_skin/profile.h"

vec3 transmittance(float thickness_mm) {
    float s = max(thickness_mm, 0.0);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < SKIN_GAUSSIANS; ++i) sum += skin_weight[i] * exp(-s * s / skin_variance_mm2[i]);
    return sum;
}
