// One sample of the two integrals that the split sum keeps in a table.
#include "14_environment/ggx.glsl"
#include "14_environment/importance_sample_ggx.glsl"

#ifndef SPLIT_SUM_GIVEN  // checks have samples of their own
const uint split_sum_threads = 256u;

// B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH course, 2013: under light of radiance 1 from everywhere a surface
// with Schlick's Fresnel reflects f0 A + B. Of sample i the (A, B).
vec2 split_sum_sample(uint i, uint samples, float n_dot_v, float alpha) {
    vec3 to_eye = vec3(sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)), 0.0, n_dot_v);
    vec2 random = hammersley(i, samples);
    vec3 half_vector = importance_sample_ggx(random.yx, alpha);
    float v_dot_h = dot(to_eye, half_vector);
    float n_dot_l = 2.0 * v_dot_h * half_vector.z - n_dot_v;
    if (n_dot_l <= 0.0 || v_dot_h <= 0.0) return vec2(0.0);
    // Over the density of l: D n·h / (4 v·h).
    float weight = ggx_visibility(n_dot_l, n_dot_v, alpha) * n_dot_l * 4.0 * v_dot_h / max(half_vector.z, 1e-6);
    float power = schlick_power(v_dot_h);
    return weight * vec2(1.0 - power, power);
}
#endif
