// The distribution of facets: computed, or from a table of 8 bits.
#include "12_skin/beckmann.glsl"
#include "12_skin/facets_table.glsl"

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
