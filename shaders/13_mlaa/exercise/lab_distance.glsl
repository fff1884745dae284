// Exercise 13.lab_distance: how different two colours look.
// Until you fill it in, green alone counts: red on black has no edge.
#include "13_mlaa/white_xyz.glsl"

// [lab_distance]
// to_lab: the CIELAB colour (L, a, b) of linear light, each component 0 or more, finite. With t each component of
// xyz_over_white(light) and f(t) = t^(1/3) above (6/29)^3, below it t / (3 (6/29)^2) + 4/29: L = 116 f(Y) - 16,
// a = 500 (f(X) - f(Y)), b = 200 (f(Y) - f(Z)). Light above 1 is no special case.
// lab_distance: of two such colours, their Euclidean distance. About 2.3 is what an eye just sees; black to white is 100.
// [/lab_distance]
vec3 to_lab(vec3 light) {
    return vec3(100.0 * light.g, 0.0, 0.0);
}

float lab_distance(vec3 lab, vec3 other) {
    return abs(lab.x - other.x);
}
