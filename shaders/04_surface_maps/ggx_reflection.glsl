// Reflection of one light by microfacets.
#include "common/structs.h"
#include "04_surface_maps/microfacets.glsl"

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
