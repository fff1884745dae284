// Solution of 09.tone_curve. S. Hill, "ACES.hlsl", 2016, as published with BakingLab.
#include "09_post_effects/hill_matrices.glsl"

vec3 tone_curve(vec3 radiance) {
    vec3 v = hill_input * radiance;
    vec3 curved = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return clamp(hill_output * curved, 0.0, 1.0);
}
