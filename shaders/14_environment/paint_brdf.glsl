// Car paint below its clear coat in a light of the scene: by a table over (n.l, n.v), a formula or a measured BRDF.
#include "14_environment/measured_brdf.glsl"
#include "14_environment/paint_data.h"
#include "14_environment/paint_model.glsl"

uniform sampler2D paint_table;

// BRDF per steradian.
vec3 paint_brdf(float n_dot_l, float n_dot_v, float l_dot_v) {
#if PAINT_METHOD == PAINT_METHOD_MEASURED
    return measured_brdf(n_dot_l, n_dot_v, l_dot_v);
#elif PAINT_METHOD == PAINT_METHOD_FIT
    return through_coat(n_dot_l, n_dot_v) * mix(pigment_brdf(n_dot_l, n_dot_v),
                                                flake_brdf(n_dot_l, n_dot_v, l_dot_v) * paint_layers.flake_color,
                                                paint_layers.flakes);
#else
    vec2 at = vec2(n_dot_v, n_dot_l) * float(PAINT_TEXELS - 1) + 0.5;
    return textureLod(paint_table, at / vec2(textureSize(paint_table, 0)), 0.0).rgb;
#endif
}
