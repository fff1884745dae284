// Microfacets: GGX with Smith's height-correlated masking, and reflection of a light by a microfacet coat.
#include "04_surface_maps/ggx_visibility.glsl"
#include "04_surface_maps/plain_draw.glsl"
#include "common/schlick.glsl"
#include "common/structs.h"

const float pi = 3.14159265358979;

// GGX distribution per steradian of half vectors (T. Trowbridge and K. Reitz, 1975; B. Walter et al., "Microfacet
// Models for Refraction through Rough Surfaces", EGSR 2007, equation 33).
float ggx_density(float n_dot_h, float alpha) {
    float square = alpha * alpha, c = n_dot_h * n_dot_h;
    float d = c * square + (1.0 - c);  // c (square - 1) + 1 would cancel for c near 1
    return square / max(pi * d * d, 1e-30);
}

// [multiscatter]
// Energy that GGX loses by dropping second microfacet hits: C. Fdez-Aguera, "A Multiple-Scattering Microfacet Model
// for Real-Time Image-based Lighting", JCGT 8(1), 2019. In units of irradiance over pi.
vec3 multiple_scattering(vec3 f0, vec2 ab) {
    float missing = 1.0 - ab.x - ab.y;
    vec3 single = f0 * ab.x + ab.y, mean = f0 + (1.0 - f0) / 21.0;
    return single * mean * missing / (1.0 - mean * missing);
}
// [/multiscatter]

// A coat of microfacets over a matt body. E is the share of white light that leaves after one microfacet, for a direction;
// what it leaves is spread as (1 - E(v)) (1 - E(l)) / (1 - mean E) over views and lights, and the light that the body
// gets likewise. So camera and light can be exchanged, and the hemisphere gets no more than arrives: C. Kelemen and
// L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001; C. Kulla and A. Conty,
// "Revisiting Physically Based Shading at Imageworks", SIGGRAPH course, 2017.
struct Coat {
    vec3 f0;            // reflectance at normal incidence
    vec3 single;        // shares of light from everywhere that reach this view: after one microfacet,
    vec3 multiple;      // after several,
    vec3 entering;      // and from the body
    vec3 per_missing;   // share of the light without direction that leaves the microfacets
    vec2 means;         // A and B over all directions, by their cosine
    vec3 body_f0;       // reflectance and share of the coat over the body, where the rest is bare metal
    vec3 body_missing;
};

// Two surfaces side by side: a coat over a body, and bare metal.
struct Blend {
    float coated;  // share of the coated one
    vec3 coat_f0, metal_f0;
};

// Metalness m blends plastic and metal of one base colour: the body is (1 - m) base and f0 is 0.04 (1 - m) + m base, which
// give both back (glTF 2.0, appendix B, adds the light of the two). The brightest channel decides m; a base below 0.04 is
// the same surface for any m. Without metalness the coat lies over the whole body.
Blend blend_of(vec3 f0, vec3 body, bool has_metalness) {
    if (!has_metalness) return Blend(1.0, f0, f0);
    float b = max(body.r, max(body.g, body.b)), f = max(f0.r, max(f0.g, f0.b)), sum = b + f;
    float root = sqrt(max(sum * sum - 0.16 * b, 0.0));
    float coated = min(f > 0.04 ? 2.0 * b / (sum + root) : (sum + root) / 0.08, 1.0);
    return Blend(coated, vec3(0.04), clamp((f0 - 0.04 * coated) / max(1.0 - coated, 1e-4), 0.0, 1.0));
}

vec3 missing_share(vec3 f0, float kept) {
    vec3 mean_fresnel = f0 + (1.0 - f0) / 21.0;
    return mean_fresnel * mean_fresnel * kept / (1.0 - mean_fresnel * (1.0 - kept));
}

// `ab`: A and B of the split sum for this view; their means over all directions.
Coat coat_of(vec3 f0, Blend blend, vec4 ab) {
    float kept = ab.z + ab.w, missing = 1.0 - ab.x - ab.y;
    vec3 body_missing = missing_share(blend.coat_f0, kept);
    vec3 per_missing = mix(missing_share(blend.metal_f0, kept), body_missing, blend.coated);
    vec3 enters = 1.0 - blend.coat_f0 * ab.x - ab.y - body_missing * missing;
    return Coat(f0, f0 * ab.x + ab.y, per_missing * missing, max(enters, 0.0), per_missing, ab.zw, blend.coat_f0,
                body_missing);
}

// Factors of `multiple` and of `entering` for a light whose direction has this A and B; 1 on average.
float multiple_towards(Coat coat, vec2 ab) {
    return (1.0 - ab.x - ab.y) / max(1.0 - coat.means.x - coat.means.y, 1e-4);
}

vec3 entering_towards(Coat coat, vec2 ab) {
    vec3 enters = 1.0 - coat.body_f0 * ab.x - ab.y - coat.body_missing * (1.0 - ab.x - ab.y);
    vec3 mean = 1.0 - coat.body_f0 * coat.means.x - coat.means.y -
                coat.body_missing * (1.0 - coat.means.x - coat.means.y);
    return max(enters, 0.0) / max(mean, 1e-4);
}

// GGX alpha of a Blinn–Phong exponent (B. Walter et al., EGSR 2007, section 5.2). Exponents are at most 8192, so alpha
// is at least 1/64.
float alpha_of(float shininess) { return sqrt(2.0 / (shininess + 2.0)); }

// Blinn–Phong exponent equivalent to the coat's alpha.
float shininess_of(float shininess, float alpha) {
#if SURFACE_GGX
    return clamp(2.0 / max(alpha * alpha, 1e-8) - 2.0, 0.0, most_shininess);
#else
    return shininess;
#endif
}

// Light in the unit of white's radiance, hence the pi. Coloured by Fresnel's term already (Schlick, 1994). `ab`: A and B of
// the split sum for the light's direction.
// [ggx]
Reflected reflect_by_ggx(Surface surface, Coat coat, vec2 ab, vec3 to_light) {
    float n_dot_l = dot(surface.normal, to_light);
    if (n_dot_l <= 0.0) return Reflected(vec3(0.0), vec3(0.0));
    float n_dot_v = clamp(dot(surface.normal, surface.to_eye), 1e-3, 1.0), alpha = alpha_of(surface.shininess);
    vec3 between = to_light + surface.to_eye, h = between * inversesqrt(max(dot(between, between), 1e-12));
    vec3 fresnel = mix(coat.f0, vec3(1.0), schlick_power(dot(surface.to_eye, h)));
    float density = ggx_density(clamp(dot(surface.normal, h), 0.0, 1.0), alpha);
    vec3 specular = pi * density * ggx_visibility(n_dot_l, n_dot_v, alpha) * fresnel;
    return Reflected(coat.entering * entering_towards(coat, ab) * n_dot_l,
                     (specular + coat.multiple * multiple_towards(coat, ab)) * n_dot_l);
}
// [/ggx]
