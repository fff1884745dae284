// Reflection and transmission of a skin's surface: the module Skin for shaders.
#include "12_skin/beckmann.glsl"
#include "12_skin/schlick_fresnel.glsl"

layout(scalar) uniform SkinBlock {
    float before;
    float roughness, specular_scale, f0;
    float wrap, inwards_mm, translucency;
} skin;

// Tabulated specular terms, if the knob says so.
#if SKIN_SPECULAR == SKIN_SPECULAR_TABLES
uniform sampler2D skin_facets;  // x: the distribution over n·h along u and m along v, encoded; y: the rise of Schlick's F
#endif

// The distribution of facets: computed, or from a table of 8 bits.
// E. d'Eon and D. Luebke, "Advanced Techniques for Realistic Real-Time Skin Rendering", GPU Gems 3, chapter 14, 2007: half
// of the tenth root fits into 0 to 1, as long as the distribution is below 1024.
float encode_facets(float facets) { return 0.5 * pow(max(facets, 0.0), 0.1); }
float decode_facets(float code) {
    float x = 2.0 * code, x2 = x * x, x4 = x2 * x2;
    return x4 * x4 * x2;
}

float beckmann_of(float n_dot_h, float m) {
#if SKIN_SPECULAR == SKIN_SPECULAR_TABLES
    if (n_dot_h <= 0.0) return 0.0;
    vec2 size = vec2(textureSize(skin_facets, 0));
    return decode_facets(textureLod(skin_facets, (0.5 + vec2(n_dot_h, m) * (size - 1.0)) / size, 0.0).r);
#else
    return beckmann(n_dot_h, m);
#endif
}

// Fresnel's reflectance: computed, or from the table's second number.
float fresnel_of(float cosine, float f0) {
#if SKIN_SPECULAR == SKIN_SPECULAR_TABLES
    float size = float(textureSize(skin_facets, 0).x);
    float rise = textureLod(skin_facets, vec2((0.5 + clamp(cosine, 0.0, 1.0) * (size - 1.0)) / size, 0.5), 0.0).g;
    return f0 + (1.0 - f0) * rise;
#else
    return schlick_fresnel(cosine, f0);
#endif
}

// Light reflected by facets does not enter the skin, and leaving light meets them again.
uniform sampler2D skin_reflected;  // x: over the cosine along u, over m along v; y: the mean over all directions

vec2 reflected_share(float cosine, float m) {
    vec2 size = vec2(textureSize(skin_reflected, 0));
    return textureLod(skin_reflected, (0.5 + clamp(vec2(cosine, m), 0.0, 1.0) * (size - 1.0)) / size, 0.0).xy;
}

// C. Kelemen and L. Szirmay-Kalos, 2001: with these two factors a white surface returns all light, for any `scale` of
// the specular reflection and any roughness m.
float way_in(float cosine, float m, float scale) {
    vec2 share = scale * reflected_share(cosine, m);
    return (1.0 - share.x) / max(1.0 - share.y, 1e-3);
}

float way_out(float cosine, float m, float scale) { return 1.0 - scale * reflected_share(cosine, m).x; }
