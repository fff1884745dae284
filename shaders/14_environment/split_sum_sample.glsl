// One sample of the two integrals that the split sum keeps in a table.
#include "14_environment/ggx.glsl"

#ifndef SPLIT_SUM_GIVEN  // checks have samples of their own
const uint split_sum_threads = 256u;

// A half vector among those visible from `to_eye`: E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT
// 7(4), 2018. At grazing angles others are mostly hidden.
vec3 visible_half_vector(vec2 random, vec3 to_eye, float alpha) {
    vec3 eye = normalize(vec3(alpha * to_eye.xy, to_eye.z));  // where the surface is a half sphere
    float r = sqrt(random.x), phi = 2.0 * pi * random.y;
    vec2 disc = r * vec2(cos(phi), sin(phi));
    vec3 across = eye.z < 0.9999 ? normalize(cross(vec3(0.0, 0.0, 1.0), eye)) : vec3(1.0, 0.0, 0.0);
    float share = 0.5 * (1.0 + eye.z);  // of the disc's lower half that is seen
    disc.y = (1.0 - share) * sqrt(1.0 - disc.x * disc.x) + share * disc.y;
    vec3 n = disc.x * across + disc.y * cross(eye, across) + sqrt(max(0.0, 1.0 - dot(disc, disc))) * eye;
    return normalize(vec3(alpha * n.xy, max(n.z, 0.0)));
}

// [split_sum_sample]
// B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH course, 2013: under light of radiance 1 from everywhere a surface
// with Schlick's Fresnel reflects f0 A + B. Of sample i the (A, B).
vec2 split_sum_sample(uint i, uint samples, float n_dot_v, float alpha) {
    vec3 to_eye = vec3(sqrt(max(1.0 - n_dot_v * n_dot_v, 0.0)), 0.0, n_dot_v);
    vec3 half_vector = visible_half_vector(hammersley(i, samples), to_eye, alpha);
    float v_dot_h = dot(to_eye, half_vector);
    float n_dot_l = 2.0 * v_dot_h * half_vector.z - n_dot_v;
    if (n_dot_l <= 0.0 || v_dot_h <= 0.0) return vec2(0.0);
    // Masking and shadowing over masking alone.
    float square = alpha * alpha, v = sqrt(n_dot_v * n_dot_v * (1.0 - square) + square);
    float weight = 2.0 * n_dot_l * (n_dot_v + v) * ggx_visibility(n_dot_l, n_dot_v, alpha);
    float power = schlick_power(v_dot_h);
    return weight * vec2(1.0 - power, power);
}
// [/split_sum_sample]
#endif
