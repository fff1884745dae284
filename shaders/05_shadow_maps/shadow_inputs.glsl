// What the module Shadow binds.
#include "05_shadow_maps/shadow_data.h"

layout(scalar) readonly buffer ShadowLightBuffer { ShadowLight shadow_lights[]; };
layout(scalar) readonly buffer ShadowViewBuffer { ShadowView shadow_views[]; };
layout(scalar) uniform ShadowEyeBlock { ShadowEye shadow_eye; };
layout(scalar) uniform ShadowBlock {
    float bias_m, slope, normal_offset;
    int kernel, taps, search_taps;
    float exponent, exponent_negative, min_variance, moment_bias, bleed;
} shadow;
uniform sampler2DArray shadow_moments;  // where the method has any
