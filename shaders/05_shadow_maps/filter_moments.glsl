// Filters of blurred moments: variance, exponential variance and moment shadow maps.
#include "05_shadow_maps/moments.glsl"

// Visibility from the mip whose texels are about as wide as the pixel on the surface. `texel`: width in level 0,
// metres.
float from_moments(ShadowView view, Receiver r, float texel, float pixel) {
#if SHADOW_MIPS
    float lod = max(log2(max(pixel, 1e-9) / texel), 0.0);
#else
    float lod = 0.0;
#endif
    vec4 moments = textureLod(shadow_moments, vec3(r.place.xy, view.layer), lod);
    float depth = linear_depth(view, r.place.z);
#if SHADOW_METHOD == SHADOW_METHOD_VSM
    float visible = chebyshev(moments.xy, depth, shadow.min_variance);
#elif SHADOW_METHOD == SHADOW_METHOD_EVSM
    float visible = evsm(moments, depth, shadow.exponent, shadow.exponent_negative, shadow.min_variance);
#else
    float visible = msm(moments, depth, shadow.moment_bias);
#endif
    return clamp((visible - shadow.bleed) / (1.0 - shadow.bleed), 0.0, 1.0);  // less bleeding, darker penumbrae
}

// Shadow filter interface; see filter_pcf.glsl.
float filter_reach(ShadowLight light, ShadowView view, vec3 position) { return 0.5; }

float filtered(ShadowLight light, ShadowView view, Receiver r, float texel, float pixel) {
    return from_moments(view, r, texel, pixel);
}
