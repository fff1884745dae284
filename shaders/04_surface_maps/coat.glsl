// Reflection model of the surface: Blinn–Phong, or microfacets over a diffuse body.
#include "02_lambert_phong/blinn_phong_light.glsl"
#include "04_surface_maps/microfacets.glsl"
#include "04_surface_maps/plain_draw.glsl"
#define HAS_COAT

#if SURFACE_GGX
uniform sampler2D ggx_albedos;

// State of the surface being lit.
Coat lit_coat;
vec3 lit_body;

// Where the tables of GGX hold a direction at this cosine and this roughness: see 04_surface_maps/ggx_table.h.
vec2 in_ggx_table(float cosine, float shininess) {
    vec2 size = vec2(textureSize(ggx_albedos, 0));
    return (vec2(1.0 - sqrt(1.0 - clamp(cosine, 1e-3, 1.0)), sqrt(alpha_of(shininess))) * (size - 1.0) + 0.5) / size;
}

vec4 albedos_at(Surface surface, vec3 direction) {
    return textureLod(ggx_albedos, in_ggx_table(dot(surface.normal, direction), surface.shininess), 0.0);
}

#if SURFACE_BODY == SURFACE_BODY_OREN_NAYAR
// EON rough diffuse BRDF (J. Portsmouth, P. Kutz and S. Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF",
// JCGT 14(1), 2025): directional albedo of single scattering at this cosine.
float single_share(float cosine, float roughness) {
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0)), angle = acos(clamp(cosine, -1.0, 1.0));
    float g = sine * (angle - sine * cosine) + 2.0 / 3.0 * (sine / max(cosine, 1e-4) * (1.0 - sine * sine * sine) - sine);
    return (1.0 + roughness / pi * g) / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * roughness);
}

vec3 rough_diffuse(Surface surface, vec3 albedo, float roughness, vec3 to_light) {
    float l = max(dot(surface.normal, to_light), 0.0), v = max(dot(surface.normal, surface.to_eye), 0.0);
    float s = dot(to_light, surface.to_eye) - l * v, most = max(max(l, v), 1e-4);
    float single = (1.0 + roughness * (s > 0.0 ? s / most : s)) / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * roughness);
    float mean = (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * pi)) * roughness) / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * roughness);
    float twice = (1.0 - single_share(l, roughness)) * (1.0 - single_share(v, roughness)) / max(1.0 - mean, 1e-6);
    return single + albedo * mean / (1.0 - albedo * (1.0 - mean)) * twice;
}
#endif

#endif

// Must run before the first light.
void coat_surface(Surface surface, vec3 f0, vec3 body, bool has_metalness) {
#if SURFACE_GGX
    lit_coat = coat_of(f0, blend_of(f0, body, has_metalness), albedos_at(surface, surface.to_eye));
    lit_body = body;
#endif
}

// Factor of the specular sum; 1 for GGX, which Fresnel has coloured.
vec3 specular_factor(vec3 specular) {
#if SURFACE_GGX
    return vec3(1.0);
#else
    return specular;
#endif
}

// Ambient light reflected by the coat; `otherwise` without one.
vec3 ambient_of_coat(vec3 otherwise) {
#if SURFACE_GGX
    vec3 everywhere = lit_coat.single + lit_coat.multiple;
    return everywhere - (1.0 - lit_coat.entering) * lit_body;  // remainder after the body
#else
    return otherwise;
#endif
}

#include "03_attenuation/lighting.glsl"

Reflected reflect_light(Surface surface, vec3 to_light) {
#if SURFACE_GGX
    Reflected reflected = reflect_by_ggx(surface, lit_coat, albedos_at(surface, to_light).rg, to_light);
#if SURFACE_BODY == SURFACE_BODY_OREN_NAYAR
    reflected.diffuse *= rough_diffuse(surface, lit_body, sqrt(alpha_of(surface.shininess)), to_light);
#endif
    return reflected;
#else
    return reflect_by_blinn_phong(surface, to_light);
#endif
}
