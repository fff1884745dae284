// Solution of 16.noise_4d.
#include "16_volume/lattice_4d.glsl"

float noise_4d(ivec4 cell, vec4 f) {
    vec4 s = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec4 corner = (ivec4(i) >> ivec4(0, 1, 2, 3)) & 1;
        vec4 weight = mix(1.0 - s, s, vec4(corner));
        sum += weight.x * weight.y * weight.z * weight.w * lattice_4d(cell + corner);
    }
    return sum;
}
