// Solution of 12.gaussian_profile.
#include "12_skin/profile.h"

vec3 gaussian_profile(float r_mm) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < SKIN_GAUSSIANS; ++i) {
        float v = skin_variance_mm2[i];
        sum += skin_weight[i] * exp(-0.5 * r_mm * r_mm / v) / (6.2831853 * v);
    }
    return sum;
}
