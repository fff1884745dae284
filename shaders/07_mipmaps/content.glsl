// Content of a texel: decode() gives values that may be averaged, encode() is its inverse.
#include "07_mipmaps/to_linear.glsl"
#include "07_mipmaps/from_linear.glsl"

// Weight of a colour with alpha 0, so that holes take the colour around them.
const float faint = 1.0 / 1024.0;

// [decode]
vec4 decode(vec4 texel) {
#if MIPS_CONTENT == MIPS_CONTENT_SRGB
    return vec4(srgb_to_linear(texel.rgb), texel.a);
#elif MIPS_CONTENT == MIPS_CONTENT_NORMAL
    return vec4(normal_to_linear(texel), 1.0);
#elif MIPS_CONTENT == MIPS_CONTENT_CUTOUT
    return vec4(srgb_to_linear(texel.rgb) * (texel.a + faint), texel.a);
#elif MIPS_CONTENT == MIPS_CONTENT_ROUGHNESS
    return vec4(texel.r, roughness_to_linear(texel.g), texel.ba);
#else
    return texel;
#endif
}
// [/decode]

vec4 encode(vec4 mean) {
#if MIPS_CONTENT == MIPS_CONTENT_SRGB
    return vec4(linear_to_srgb(mean.rgb), mean.a);
#elif MIPS_CONTENT == MIPS_CONTENT_NORMAL
    return normal_from_linear(mean.xyz);
#elif MIPS_CONTENT == MIPS_CONTENT_CUTOUT
    return vec4(linear_to_srgb(mean.rgb / (max(mean.a, 0.0) + faint)), mean.a);
#elif MIPS_CONTENT == MIPS_CONTENT_ROUGHNESS
    return vec4(mean.r, roughness_from_linear(mean.g), mean.ba);
#else
    return mean;
#endif
}
