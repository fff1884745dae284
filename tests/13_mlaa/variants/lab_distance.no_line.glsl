// wrong: to_lab(light = (0,
#include "13_mlaa/white_xyz.glsl"

vec3 to_lab(vec3 light) {
    const float bend = 6.0 / 29.0;
    vec3 t = xyz_over_white(light);
    vec3 line = t / (3.0 * bend * bend) + 4.0 / 29.0;
    vec3 root = pow(max(t, bend * bend * bend), vec3(1.0 / 3.0));
    vec3 f = root;
    return vec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
}

float lab_distance(vec3 lab, vec3 other) { return distance(lab, other); }
