// Car paint without its clear coat's own reflection: pigment, and metal flakes above it, both below the coat. The model from
// which 14_environment/paint_table.comp makes its table.
#include "14_environment/ggx.glsl"

layout(scalar) uniform PaintBlock {
    vec3 color, edge_color, flake_color;
    float flakes, flake_roughness, coat_roughness, flake_mm;
} paint;

#if PAINT_METHOD == PAINT_METHOD_LAYERS
#define paint_layers paint
#else
// The model fitted to measured paint: PaintFit of 14_environment/paint_fit.h.
layout(scalar) uniform PaintFitBlock {
    vec3 color, edge_color, flake_color;
    float flakes, flake_roughness;
} paint_fit;
#define paint_layers paint_fit
#endif

const float coat_f0 = 0.04, coat_index = 1.5;

// The cosine within the coat of a ray that meets it at `cosine`: Snell's law.
float below_coat(float cosine) {
    return sqrt(1.0 - (1.0 - cosine * cosine) / (coat_index * coat_index));
}

// The pigment tints light twice, on its way in and out, more strongly on slanted paths.
vec3 pigment_brdf(float n_dot_l, float n_dot_v) {
    float way = 0.5 * (1.0 / below_coat(n_dot_l) + 1.0 / below_coat(n_dot_v)) - 1.0;  // 0 to 0.34
    return mix(paint_layers.color, paint_layers.edge_color, clamp(3.0 * way, 0.0, 1.0)) / pi;
}

// The flakes: a GGX lobe, averaged over the angle between the two planes, which the table does not have. Over n squared,
// because refraction spreads light on its way out (E. Veach, Ph.D. thesis, Stanford, 1997, section 5.2).
float flake_brdf(float n_dot_l, float n_dot_v) {
    float l = below_coat(n_dot_l), v = below_coat(n_dot_v);
    float alpha = paint_layers.flake_roughness * paint_layers.flake_roughness;
    float across = sqrt((1.0 - l * l) * (1.0 - v * v)), sum = 0.0;
    const int angles = 32;
    for (int i = 0; i < angles; ++i) {
        float l_dot_v = l * v + across * cos(2.0 * pi * (float(i) + 0.5) / float(angles));
        float n_dot_h = min((l + v) / sqrt(max(2.0 + 2.0 * l_dot_v, 1e-6)), 1.0);
        sum += ggx_density(n_dot_h, alpha);
    }
    return ggx_visibility(l, v, alpha) * sum / (float(angles) * coat_index * coat_index);
}

// One direction pair instead of the mean: l and v refracted keep their azimuths.
float flake_brdf(float n_dot_l, float n_dot_v, float l_dot_v) {
    float l = below_coat(n_dot_l), v = below_coat(n_dot_v);
    float alpha = paint_layers.flake_roughness * paint_layers.flake_roughness;
    float refracted = l * v + (l_dot_v - n_dot_l * n_dot_v) / (coat_index * coat_index);
    float n_dot_h = min((l + v) / sqrt(max(2.0 + 2.0 * refracted, 1e-6)), 1.0);
    return ggx_visibility(l, v, alpha) * ggx_density(n_dot_h, alpha) / (coat_index * coat_index);
}

// Transmittance of the coat, in and out.
float through_coat(float n_dot_l, float n_dot_v) {
    return (1.0 - coat_f0) * (1.0 - schlick_power(n_dot_l)) * (1.0 - coat_f0) * (1.0 - schlick_power(n_dot_v));
}
