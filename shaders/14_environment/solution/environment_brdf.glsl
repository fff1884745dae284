// Solution of 14.environment_brdf (B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH course, 2013).
#include "14_environment/visible_half_vector.glsl"

vec2 environment_brdf(vec2 random, float n_dot_v, float alpha) {
    vec3 to_eye = vec3(sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)), 0.0, n_dot_v);
    vec3 half_vector = visible_half_vector(random, to_eye, alpha);
    float v_dot_h = dot(to_eye, half_vector);
    float n_dot_l = 2.0 * v_dot_h * half_vector.z - n_dot_v;
    if (n_dot_l <= 0.0 || v_dot_h <= 0.0) return vec2(0.0);
    // Masking and shadowing over masking alone.
    float square = alpha * alpha, v = sqrt(n_dot_v * n_dot_v * (1.0 - square) + square);
    float weight = 2.0 * n_dot_l * (n_dot_v + v) * ggx_visibility(n_dot_l, n_dot_v, alpha);
    float power = schlick_power(v_dot_h);
    return weight * vec2(1.0 - power, power);
}
