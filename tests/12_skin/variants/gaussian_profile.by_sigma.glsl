// right
#include "12_skin/profile.h"
vec3 gaussian_profile(float r_mm) {
    vec3 sum = vec3(0.0);
    for (int i = 5; i >= 0; --i) {
        float sigma = sqrt(skin_variance_mm2[i]), x = r_mm / sigma;
        sum += 0.15915494 * skin_weight[i] * exp(-x * x / 2.0) / (sigma * sigma);
    }
    return sum;
}
