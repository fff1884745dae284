// wrong: gaussian_profile(r_mm =
#include "12_skin/profile.h"
vec3 gaussian_profile(float r_mm) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 6u; ++i) sum += skin_weight[i] * exp(-0.5 * r_mm * r_mm / skin_variance_mm2[i]) / skin_variance_mm2[i];
    return sum;
}
