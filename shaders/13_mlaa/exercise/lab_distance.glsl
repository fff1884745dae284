// Exercise 13.lab_distance: the visible difference of two colours.
// Starter: only green counts: red on black has no edge.
#include "13_mlaa/white_xyz.glsl"

// [lab_distance]
// to_lab: returns the CIELAB colour (L, a, b) of linear light whose components are
// finite and 0 or more; they may exceed 1. Let X, Y, Z be the components of
// xyz_over_white(light). Apply to each of them
//
//     f(t) = t^(1/3)                           above (6/29)^3
//     f(t) = t / (3 (6/29)^2) + 4/29           up to it
//
// Then L = 116 f(Y) - 16, a = 500 (f(X) - f(Y)), b = 200 (f(Y) - f(Z)).
//
// lab_distance: returns the Euclidean distance of two such colours. A distance of about
// 2.3 is just visible; black and white are 100 apart.
// [/lab_distance]
vec3 to_lab(vec3 light) {
    return vec3(100.0 * light.g, 0.0, 0.0);
}

float lab_distance(vec3 lab, vec3 other) {
    return abs(lab.x - other.x);
}
