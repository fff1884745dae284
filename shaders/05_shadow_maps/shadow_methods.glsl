// The methods, of which one is compiled in.
#include "05_shadow_maps/compare_depth.glsl"
#include "05_shadow_maps/light_clip_position.glsl"
#include "05_shadow_maps/map_depth.glsl"
#include "05_shadow_maps/moments.glsl"
#include "05_shadow_maps/pcf.glsl"
#include "05_shadow_maps/pcf_single.glsl"
#include "05_shadow_maps/pcss.glsl"

// [filter_reach]
// How far in texels along u and along v the method asks the map: what the bias has to reckon with.
float filter_reach(ShadowLight light, ShadowView view, vec3 position) {
#if SHADOW_METHOD == SHADOW_METHOD_PCF
    return 0.5 * float(shadow.kernel) + 0.5;
#elif SHADOW_METHOD == SHADOW_METHOD_PCSS
    float distance = lamp_distance(view, max(light_clip_position(view.to_clip, position).z, 0.0));
    return 1.0 + float(map_texels()) * search_radius(light, view, distance);
#else
    return 0.5;
#endif
}
// [/filter_reach]

// [hard]
float hard(Receiver r, uint layer) {
    // The texel's depth is right in its middle: there the surface's own is compared.
    vec2 middle = (floor(r.place.xy * float(map_texels())) + 0.5) / float(map_texels());
    vec3 place = vec3(r.place.xy, plane_depth(r, middle));
    return compare_depth(place, read_depth(r.place.xy, layer));
}
// [/hard]

// [from_moments]
// From a mip whose texels are about as wide as the pixel is on the surface. `texel`: of the first one, in metres.
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
    return clamp((visible - shadow.bleed) / (1.0 - shadow.bleed), 0.0, 1.0);  // less of what leaks, and of penumbrae
}
// [/from_moments]

// [filtered]
float filtered(ShadowLight light, ShadowView view, Receiver r, float texel, float pixel) {
#if SHADOW_METHOD == SHADOW_METHOD_HARD
    return hard(r, view.layer);
#elif SHADOW_METHOD == SHADOW_METHOD_PCF && SHADOW_FETCH == SHADOW_FETCH_SINGLE
    return pcf_single(r, view.layer, shadow.kernel | 1);
#elif SHADOW_METHOD == SHADOW_METHOD_PCF
    return pcf(r, view.layer, shadow.kernel | 1);
#elif SHADOW_METHOD == SHADOW_METHOD_PCSS
    return pcss(light, view, r);
#else
    return from_moments(view, r, texel, pixel);
#endif
}
// [/filtered]
