// right
#include "09_post_effects/hill_matrices.glsl"
vec3 tone_curve(vec3 radiance) {
    vec3 v = hill_input * radiance;
    vec3 a = v * v + 0.0245786 * v - 0.000090537, b = 0.983729 * v * v + 0.4329510 * v + 0.238081;
    return min(max(hill_output * (a / b), 0.0), 1.0);
}
