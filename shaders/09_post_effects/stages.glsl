// Effects of a single pixel, in order. Disabled ones are not compiled.
#include "09_post_effects/post_block.glsl"
#include "09_post_effects/bayer_dither.glsl"
#include "common/srgb.glsl"
#include "09_post_effects/contrast_saturation.glsl"
#include "09_post_effects/exposure_gamma.glsl"
#include "09_post_effects/film_grain.glsl"
#include "09_post_effects/noise.glsl"
#include "common/structs.h"
#include "09_post_effects/aces.glsl"
#include "09_post_effects/tone_curve.glsl"
#include "09_post_effects/vignette.glsl"

// Tone curves: unbounded light to the range of a screen.

// K. Narkowicz, "ACES filmic tone mapping curve", 2015: one fraction for each channel.
vec3 narkowicz(vec3 x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

// Khronos PBR neutral tone mapper, 2024: colours stay as they are up to 0.8, then the peak is compressed and drawn to white.
vec3 neutral(vec3 c) {
    const float start = 0.8 - 0.04, room = 1.0 - start;
    float least = min(c.r, min(c.g, c.b));
    c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < start) return c;
    float shown = 1.0 - room * room / (peak + room - start);
    return mix(vec3(shown), c * (shown / peak), 1.0 / (0.15 * (peak - shown) + 1.0));
}

// T. Sobotka's AgX, 2022, by B. Wrensch's fit of its curve, "Minimal AgX implementation", 2023. Columns.
vec3 agx(vec3 c) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992, 0.878468636469772,
                            0.0784336, 0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438, -0.0980208811401368,
                             1.15190312990417, -0.0980434501171241, -0.0990297440797205, -0.0989611768448433,
                             1.15107367264116);
    const float least = -12.47393, most = 4.026069;
    vec3 x = (clamp(log2(max(inset * c, 1e-10)), least, most) - least) / (most - least);
    vec3 x2 = x * x, x4 = x2 * x2;
    vec3 curved = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
    return pow(clamp(outset * curved, 0.0, 1.0), vec3(2.2));  // output encoded for a screen of gamma 2.2
}

vec3 tone(vec3 radiance) {
    vec3 c = min(max(radiance, 0.0), LARGEST_HALF);
#if POST_TONE == POST_TONE_CLAMP
    return min(c, 1.0);
#elif POST_TONE == POST_TONE_REINHARD
    return c / (1.0 + c);
#elif POST_TONE == POST_TONE_FILM
    return 1.0 - exp(-c);
#elif POST_TONE == POST_TONE_NARKOWICZ
    return narkowicz(c);
#elif POST_TONE == POST_TONE_HILL
    return tone_curve(c);
#elif POST_TONE == POST_TONE_NEUTRAL
    return neutral(c);
#elif POST_TONE == POST_TONE_AGX
    return agx(c);
#elif POST_TONE == POST_TONE_ACES
    return reference_tone(c);
#else
    return radiance;
#endif
}

#if POST_EXPOSURE == POST_EXPOSURE_AUTOMATIC
uniform sampler2D adapted;
#endif
#if POST_GRAIN == POST_GRAIN_TEXTURE
uniform sampler2D grain_tile;
#endif
#if POST_DITHER == POST_DITHER_BLUE_NOISE
uniform sampler2D blue_noise;
#endif

// [stored]
// End of a stage. A separate pass would store and reload the value, so no compiler could fuse a product with the next
// stage's sum. The exclusive or with a host-supplied 0 prevents this here.
vec3 stored(vec3 c) { return uintBitsToFloat(floatBitsToUint(c) ^ post_now.zero); }
// [/stored]

float stops_now() {
#if POST_EXPOSURE == POST_EXPOSURE_AUTOMATIC
    return post.stops + texelFetch(adapted, ivec2(0), 0).r;
#else
    return post.stops;
#endif
}

float grain_at(ivec2 pixel) {
#if POST_GRAIN == POST_GRAIN_TEXTURE
    uvec2 moved = uvec2(vec2(0.5 + 0.5 * noise_of(uvec2(0u), post_now.grain_frame),
                             0.5 + 0.5 * noise_of(uvec2(1u), post_now.grain_frame)) * vec2(textureSize(grain_tile, 0)));
    return texelFetch(grain_tile, ivec2((uvec2(pixel) + moved) % uvec2(textureSize(grain_tile, 0))), 0).r;
#else
    return film_grain(uvec2(pixel), post_now.grain_frame);
#endif
}

// More in the middle tones; none where there is no film left to expose, or none exposed.
vec3 with_grain(vec3 c, ivec2 pixel) {
    vec3 code = encode_srgb(c);
    float y = luminance(code);
    return decode_srgb(clamp(code + post.grain_by * 4.0 * y * (1.0 - y) * grain_at(pixel), 0.0, 1.0));
}

float threshold(ivec2 pixel) {
#if POST_DITHER == POST_DITHER_BAYER_4
    return bayer(uvec2(pixel), 2);
#elif POST_DITHER == POST_DITHER_BAYER_8
    return bayer(uvec2(pixel), 3);
#elif POST_DITHER == POST_DITHER_BLUE_NOISE
    return texelFetch(blue_noise, pixel % textureSize(blue_noise, 0), 0).r;
#else
    return 0.5;
#endif
}

vec3 all_stages(vec3 c, ivec2 pixel, vec2 uv) {
#if POST_EXPOSURE != POST_EXPOSURE_OFF
    c = stored(expose(c, stops_now()));
#endif
#if POST_WHITE_BALANCE
    c = stored(max(post_now.white * c, 0.0));
#endif
#if POST_TONE != POST_TONE_OFF
    c = stored(tone(post_now.tone_gain * c));
#endif
#if POST_CONTRAST
    c = stored(contrast(c, post.contrast_by));
#endif
#if POST_BRIGHTNESS
    c = stored(max(c + post.brightness_by, 0.0));
#endif
#if POST_SATURATION
    c = stored(saturate_color(c, post.saturation_by));
#endif
#if POST_GREYSCALE
    c = stored(mix(c, vec3(luminance(c)), post.greyscale_by));
#endif
#if POST_INVERT
    c = stored(mix(c, 1.0 - clamp(c, 0.0, 1.0), post.invert_by));
#endif
#if POST_VIGNETTE
    c = stored(c * vignette(uv, post_now.whole.x / post_now.whole.y, post.vignette_strength, post.vignette_power));
#endif
#if POST_SCANLINES
    c = stored(c * (1.0 - post.scan_strength * (0.5 + 0.5 * cos(6.28318531 * (uv.y * post.scan_lines - post_now.scan_phase)))));
#endif
#if POST_FADE
    c = stored(mix(c, post.fade_color, post.fade_by));
#endif
#if POST_GAMMA
    c = stored(apply_gamma(c, post.gamma_by));
#endif
#if POST_GRAIN != POST_GRAIN_OFF
    c = stored(with_grain(c, pixel));
#endif
#if POST_DITHER != POST_DITHER_OFF
    float last = float(post.codes - 1);
    c = stored(decode_srgb(floor(last * encode_srgb(c) + threshold(pixel)) / last));
#endif
    return c;
}
