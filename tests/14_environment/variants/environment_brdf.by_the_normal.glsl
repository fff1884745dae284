// wrong: environment_brdf at n·v = 0.3; hint: almost right: at grazing angles
// Right on average: half vectors by D (n·h), of which a camera at a grazing angle sees few.
#include "14_environment/ggx.glsl"
#include "14_environment/importance_sample_ggx.glsl"

vec2 environment_brdf(vec2 random, float n_dot_v, float alpha) {
    vec3 to_eye = vec3(sqrt(1.0 - min(n_dot_v * n_dot_v, 1.0)), 0.0, n_dot_v);
    vec3 h = importance_sample_ggx(random, alpha);
    float v_dot_h = dot(to_eye, h), n_dot_l = 2.0 * v_dot_h * h.z - n_dot_v;
    if (n_dot_l <= 0.0 || v_dot_h <= 0.0) return vec2(0.0);
    float p = schlick_power(v_dot_h);
    return ggx_visibility(n_dot_l, n_dot_v, alpha) * n_dot_l * 4.0 * v_dot_h / h.z * vec2(1.0 - p, p);
}
