// Microfacets: GGX with the height-correlated masking of Smith, and the reflection of one light by them.
#include "common/schlick.glsl"
#include "common/structs.h"

const float pi = 3.14159265358979;

// T. Trowbridge and K. Reitz, 1975; B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007,
// equation 33. Per steradian of half vectors.
float ggx_density(float n_dot_h, float alpha) {
    float square = alpha * alpha, c = n_dot_h * n_dot_h;
    float d = c * square + (1.0 - c);  // c (square - 1) + 1 loses its digits where c is nearly 1
    return square / max(pi * d * d, 1e-30);
}

// Masking and shadowing over 4 n·l n·v: E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
// JCGT 3(2), 2014, equation 99. n_dot_l and n_dot_v are above 0.
float ggx_visibility(float n_dot_l, float n_dot_v, float alpha) {
    float square = alpha * alpha;
    float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - square) + square);
    float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - square) + square);
    return 0.5 / max(l + v, 1e-20);
}

// Light in the unit of white's radiance, hence the pi. Coloured by Fresnel's term already (Schlick, 1994); the rest enters
// the surface (glTF 2.0, appendix B).
// [ggx]
Reflected reflect_by_ggx(Surface surface, vec3 f0, vec3 to_light) {
    float n_dot_l = dot(surface.normal, to_light);
    if (n_dot_l <= 0.0) return Reflected(vec3(0.0), vec3(0.0));
    float n_dot_v = clamp(dot(surface.normal, surface.to_eye), 1e-3, 1.0);
    vec3 between = to_light + surface.to_eye, h = between * inversesqrt(max(dot(between, between), 1e-12));
    float alpha = sqrt(2.0 / (surface.shininess + 2.0));  // B. Walter et al., EGSR 2007, section 5.2
    vec3 fresnel = mix(f0, vec3(1.0), schlick_power(dot(surface.to_eye, h)));
    float density = ggx_density(clamp(dot(surface.normal, h), 0.0, 1.0), alpha);
    vec3 specular = pi * density * ggx_visibility(n_dot_l, n_dot_v, alpha) * fresnel;
    return Reflected((1.0 - fresnel) * n_dot_l, specular * n_dot_l);
}
// [/ggx]

// The share of light from everywhere that microfacets reflect, over f0: B. Karis, "Physically Based Shading on Mobile",
// 2014, a fit to the split sum of chapter 14.
vec2 reflected_from_everywhere(float roughness, float n_dot_v) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}
