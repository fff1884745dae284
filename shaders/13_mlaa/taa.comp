// Temporal anti-aliasing: the history of each pixel's surface, mixed with the new light.
#include "13_mlaa/accumulate.glsl"
#include "13_mlaa/clip_history.glsl"
#include "13_mlaa/ghost.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/reproject.glsl"
#include "13_mlaa/ycocg.glsl"
#include "common/view_rays.h"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform TaaStepBlock {
    mat4 to_before;
    vec2 shift;
    float inverse_near, inverse_far;
    float at_rest, in_motion, gamma;
    uint valid, rests;
} taa_step;
uniform sampler2D depth, history, behind_before;
#if MOVING
uniform sampler2D moving;
#endif
layout(rgba16f) writeonly uniform image2D light;
layout(r32f) writeonly uniform image2D behind;

const int tile = 18;
shared vec3 tile_light[tile * tile];  // YCoCg
shared float tile_depth[tile * tile];

int slot_beside(ivec2 step) {
    ivec2 place = ivec2(gl_LocalInvocationID.xy) + 1 + step;
    return tile * place.y + place.x;
}
float depth_beside(ivec2 step) { return tile_depth[slot_beside(step)]; }

void load_tile(ivec2 corner, ivec2 size) {
    for (int slot = int(gl_LocalInvocationIndex); slot < tile * tile; slot += 256) {
        ivec2 pixel = clamp(corner - 1 + ivec2(slot % tile, slot / tile), ivec2(0), size - 1);
        tile_light[slot] = to_ycocg(light_at(pixel));
        tile_depth[slot] = texelFetch(depth, pixel, 0).r;
    }
    barrier();
}

float per_metre(float stored) { return depth_to_per_metre(stored, taa_step.inverse_near, taa_step.inverse_far); }

// [motion]
struct Motion {
    vec2 pixels;     // to where the surface was
    float expected;  // its inverse distance then, per metre
    float stays;     // how much of its light stays from frame to frame
    bool known;
};

// Of the nearest of nine pixels: a silhouette moves with the object in front.
Motion motion_of(ivec2 pixel, vec2 size, mat3 depths) {
    ivec2 nearest = nearest_of_nine(depths);
    float stored = depth_beside(nearest);
#if MOVING
    vec4 moved = texelFetch(moving, clamp(pixel + nearest, ivec2(0), ivec2(size) - 1), 0);
    if (moved.a > 0.0) return Motion(moved.xy, 1.0 / moved.z, moved.a, true);
#endif
    vec2 at = vec2(pixel + nearest) + 0.5 + taa_step.shift;
    vec3 then = reproject(at, stored, size, taa_step.to_before);
    return Motion(then.xy - at, per_metre(stored) / max(then.z, 1e-6), 1.0, then.z > 0.0);
}
// [/motion]

// Whether the surface was visible at `at` in the frame before, whose nine pixels there saw no surface farther than
// `farthest`. Both are inverse distances, per metre. That they saw farther ones says nothing: all may have missed a wire.
bool keep_history(vec2 at, vec2 size, float expected, float farthest) {
    bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, size));
    return inside && farthest <= 1.05 * expected + 1e-6;
}

// Catmull-Rom in five bilinear reads, the corners left out (J. Jimenez, 2016).
vec3 history_at(vec2 at, vec2 size) {
#if TAA_RESAMPLE == TAA_RESAMPLE_BILINEAR
    return textureLod(history, at / size, 0.0).rgb;
#else
    vec2 centre = floor(at - 0.5) + 0.5, f = at - centre;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f), w12 = w1 + w2;
    vec2 before = (centre - 1.0) / size, between = (centre + w2 / w12) / size, behind = (centre + 2.0) / size;
    vec4 sum = w12.x * w12.y * vec4(textureLod(history, between, 0.0).rgb, 1.0);
    sum += w0.x * w12.y * vec4(textureLod(history, vec2(before.x, between.y), 0.0).rgb, 1.0);
    sum += w3.x * w12.y * vec4(textureLod(history, vec2(behind.x, between.y), 0.0).rgb, 1.0);
    sum += w12.x * w0.y * vec4(textureLod(history, vec2(between.x, before.y), 0.0).rgb, 1.0);
    sum += w12.x * w3.y * vec4(textureLod(history, vec2(between.x, behind.y), 0.0).rgb, 1.0);
    return max(sum.rgb / sum.a, 0.0);
#endif
}

// To the nearest half float: images may cut what they are given, which darkens a history more with every frame.
vec3 to_nearest_half(vec3 light) {
    const float least = exp2(-14.0);  // below it halves are evenly spaced
    uvec3 kept = (floatBitsToUint(light) + 0x1000u) & 0xffffe000u;
    return mix(uintBitsToFloat(kept), round(light * exp2(24.0)) * exp2(-24.0), lessThan(light, vec3(least)));
}

// [limits]
const float still = 0.05;          // pixels a frame
const float most_samples = 1024.0;  // a half float counts that far, and one sample in so many still changes it

// At rest, samples that hit a thin wire or miss it change the mean of 3x3 pixels little; a shadow changes all of it. The
// luma of the new frame's nine pixels: their mean and range.
bool same_as_before(ivec2 pixel, float mean, float lowest, float highest) {
    float before = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 beside = clamp(pixel + ivec2(x, y), ivec2(0), textureSize(picture, 0) - 1);
            float one = to_ycocg(texelFetch(history, beside, 0).rgb).x;
            before += one / 9.0;
            lowest = min(lowest, one);
            highest = max(highest, one);
        }
    return abs(mean - before) <= 0.25 * (highest - lowest) + 0.005;
}

vec3 limit(vec3 old, ivec2 pixel, bool rests) {
#if TAA_CLIPPING == TAA_CLIPPING_NONE
    return old;
#else
    vec3 lowest = tile_light[slot_beside(ivec2(0))], highest = lowest, sum = vec3(0.0), squares = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec3 one = tile_light[slot_beside(ivec2(x, y))];
            lowest = min(lowest, one);
            highest = max(highest, one);
            sum += one;
            squares += one * one;
        }
#if TAA_CLIPPING == TAA_CLIPPING_DEVIATION
    if (rests && same_as_before(pixel, sum.x / 9.0, lowest.x, highest.x)) return old;
    vec3 mean = sum / 9.0, reach = taa_step.gamma * sqrt(max(squares / 9.0 - mean * mean, 0.0));
    lowest = max(lowest, mean - reach);
    highest = min(highest, mean + reach);
#endif
    return clip_history(old, lowest, highest);
#endif
}
// [/limits]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = textureSize(picture, 0);
    load_tile(16 * ivec2(gl_WorkGroupID.xy), size);
    if (any(greaterThanEqual(pixel, size))) return;
    vec3 fresh = tile_light[slot_beside(ivec2(0))];
    vec4 mixed = vec4(fresh, 1.0);
    float farthest = 1.0;
    bool moves = false;
    mat3 depths;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y) {
            depths[x + 1][y + 1] = depth_beside(ivec2(x, y));
            farthest = min(farthest, depths[x + 1][y + 1]);
        }
    Motion motion = motion_of(pixel, vec2(size), depths);
    vec2 at = vec2(pixel) + 0.5 + motion.pixels;
    if (taa_step.valid != 0u && motion.known) {
        ivec2 texel = clamp(ivec2(at), ivec2(0), size - 1);
        bool unchanged = taa_step.rests != 0u;
        bool keep = unchanged || keep_history(at, vec2(size), motion.expected,
                                              TAA_REJECT != 0 ? texelFetch(behind_before, texel, 0).r : 0.0);
        if (keep) {
            float speed = length(motion.pixels);
            float kept = texelFetch(history, texel, 0).a;
            float worth = mix(taa_step.at_rest, taa_step.in_motion, min(speed, 1.0));
            worth = min(worth, 0.125 / max(1.0 - motion.stays, 1e-4));  // until an eighth of its slopes is another
            if (unchanged) worth = most_samples;
            vec3 old = unchanged || speed < 1e-3 ? texelFetch(history, pixel, 0).rgb : history_at(at, vec2(size));
            old = to_ycocg(old);
            if (!unchanged) old = limit(old, pixel, speed < still && motion.stays >= 1.0 && kept > 0.0);
            moves = !unchanged && speed >= still;
            mixed = accumulate(fresh, old, abs(kept), worth, TAA_WEIGHTS == TAA_WEIGHTS_TONE);
        }
    }
    imageStore(light, pixel, vec4(to_nearest_half(max(from_ycocg(mixed.xyz), 0.0)), moves ? -mixed.w : mixed.w));
    imageStore(behind, pixel, vec4(per_metre(farthest)));
}
