// Effects of a single pixel, in order. Disabled ones are not compiled.
#include "09_post_effects/post_block.glsl"
#include "09_post_effects/bayer_dither.glsl"
#include "common/srgb.glsl"
#include "09_post_effects/contrast_saturation.glsl"
#include "09_post_effects/exposure_gamma.glsl"
#include "09_post_effects/film_grain.glsl"
#include "09_post_effects/noise.glsl"
#include "09_post_effects/tone.glsl"
#include "09_post_effects/vignette.glsl"

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

// [stages]
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
// [/stages]
