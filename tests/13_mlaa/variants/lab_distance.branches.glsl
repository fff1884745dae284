// right
#include "13_mlaa/white_xyz.glsl"

vec3 to_lab(vec3 light) {
    const float bend = 6.0 / 29.0;
    vec3 t = xyz_over_white(light);
    vec3 f;
    for (int i = 0; i < 3; ++i) f[i] = t[i] > 0.008856452 ? pow(t[i], 1.0 / 3.0) : 7.787037 * t[i] + 0.13793103;
    return vec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
}

float lab_distance(vec3 lab, vec3 other) { return distance(lab, other); }
