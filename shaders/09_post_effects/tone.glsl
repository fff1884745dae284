// Tone curves: unbounded light to the range of a screen.
#include "common/structs.h"
#include "09_post_effects/aces.glsl"
#include "09_post_effects/tone_curve.glsl"

// [narkowicz]
// K. Narkowicz, "ACES filmic tone mapping curve", 2015: one fraction for each channel.
vec3 narkowicz(vec3 x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }
// [/narkowicz]

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
