// The displaced sphere: a height above each direction from its centre, and the normal of the surface that results.
#include "14_environment/beat_data.h"
#include "14_environment/beat_waves.glsl"
#include "14_environment/image_light.glsl"
#include "common/light.glsl"

layout(scalar) uniform BeatNowBlock { BeatNow beat_now; };

// Doublings of the surroundings' radiance over its mean. Their logarithm, for the brightest texel of a sky has 70 to
// 47,000 times the mean, and of a blurred level, for the sphere's triangles cannot follow single texels.
float doublings(vec3 n) {
    vec3 light = textureLod(image_light_radiance, environment_space(n), beat_now.blur).rgb;
    float mean = 0.282095 * luminance(image_light_sh[0].rgb);
    return clamp(log2(max(luminance(light), 1e-6) / max(mean, 1e-6)), -6.0, 6.0);
}

vec4 band_heights(vec3 n) {
    const vec3 exponents = vec3(2.0, 6.0, 4.0);
    vec4 sum = vec4(0.0);
    for (int band = 0; band < 3; ++band)
        sum += beat_now.heights[band] * waves(beat_now.from_world * n, beat_now.frequencies[band], exponents[band]);
    return vec4(transpose(beat_now.from_world) * sum.xyz, sum.w);
}

// The relief of the surroundings' brightness. Its gradient is measured, a texel of the level that is read to either side.
vec4 brightness_height(vec3 n) {
    if (beat_now.brightness == 0.0) return vec4(0.0);
    float step = exp2(beat_now.blur) / image_light_state.texels;
    mat3 frame = frame_around(n);
    vec3 gradient = vec3(0.0);
    for (int i = 0; i < 2; ++i)
        gradient += frame[i] * (doublings(normalize(n + step * frame[i])) - doublings(normalize(n - step * frame[i]))) /
                    (2.0 * atan(step));
    return beat_now.brightness * vec4(gradient, doublings(n));
}

vec3 place_above(vec3 n) { return (1.0 + band_heights(n).w + beat_now.brightness * doublings(n)) * n; }

vec3 displaced_normal(vec3 n) {
#if BEAT_NORMAL == BEAT_NORMAL_SPHERE
    return n;
#elif BEAT_NORMAL == BEAT_NORMAL_DIFFERENCES
    const float step = 2e-3;
    mat3 frame = frame_around(n);
    vec3 right = place_above(normalize(n + step * frame[0])) - place_above(normalize(n - step * frame[0]));
    vec3 up = place_above(normalize(n + step * frame[1])) - place_above(normalize(n - step * frame[1]));
    return normalize(cross(right, up));
#else
    return normal_above(n, band_heights(n) + brightness_height(n));
#endif
}
