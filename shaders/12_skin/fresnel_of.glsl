// Fresnel's reflectance: computed, or from the table's second number.
#include "12_skin/schlick_fresnel.glsl"
#include "12_skin/facets_table.glsl"

float fresnel_of(float cosine, float f0) {
#if SKIN_SPECULAR == SKIN_SPECULAR_TABLES
    float size = float(textureSize(skin_facets, 0).x);
    float rise = textureLod(skin_facets, vec2((0.5 + clamp(cosine, 0.0, 1.0) * (size - 1.0)) / size, 0.5), 0.0).g;
    return f0 + (1.0 - f0) * rise;
#else
    return schlick_fresnel(cosine, f0);
#endif
}
