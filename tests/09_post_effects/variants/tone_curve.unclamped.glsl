// wrong: tone_curve(
#include "09_post_effects/hill_matrices.glsl"
vec3 tone_curve(vec3 radiance) {
    vec3 v = hill_input * radiance;
    return hill_output * ((v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081));
}
