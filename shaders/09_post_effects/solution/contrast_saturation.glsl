// Solution of 09.contrast_saturation.
#include "common/light.glsl"

vec3 contrast(vec3 color, float amount) {
    if (amount == 0.0) return vec3(0.18);
    return 0.18 * pow(max(color, 0.0) / 0.18, vec3(amount));
}

vec3 saturate_color(vec3 color, float amount) {
    return max(mix(vec3(luminance(color)), color, amount), 0.0);
}
