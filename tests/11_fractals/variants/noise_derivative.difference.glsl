// wrong: noise_derivative(
#include "11_fractals/quintic_noise.glsl"

vec3 noise_derivative(ivec2 cell, vec2 f) {
    const float h = 0.01;
    return vec3(quintic_noise(cell, f), (quintic_noise(cell, f + vec2(h, 0.0)) - quintic_noise(cell, f - vec2(h, 0.0))) / (2.0 * h),
                (quintic_noise(cell, f + vec2(0.0, h)) - quintic_noise(cell, f - vec2(0.0, h))) / (2.0 * h));
}
