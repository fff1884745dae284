// Volume in front of the drawn scene: a ray for each pixel from its entry to its exit or to a solid surface.
#include "common/structs.h"
#include "16_volume/volume_inputs.glsl"
#include "16_volume/bounds.glsl"
#include "16_volume/correct_opacity.glsl"
#include "16_volume/composite_front_to_back.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform VolumeBlock { float glow, shine, threshold, shell_strength, shell_bumps, shell_scale, albedo, g; vec3 sky; int octaves, paths, light_steps, truth_samples; } volume;
#include "16_volume/shading.glsl"
#include "16_volume/walk.glsl"
#include "16_volume/exact_reads.glsl"
#include "16_volume/exact.glsl"
#include "16_volume/shell.glsl"
#include "16_volume/skip.glsl"
#include "16_volume/show.glsl"
#if VOLUME_METHOD == VOLUME_METHOD_PREINTEGRATED
uniform sampler2D volume_preintegrated;
#endif

layout(rgba16f) uniform image2D result;
layout(rgba32f) uniform image2D marched;  // light and transmittance, the mean of the history where there is one
uniform sampler2D depth;

// A number for each pixel that neighbours do not share (J. Jimenez, "Next Generation Post Processing in Call of Duty",
// SIGGRAPH 2014), moved on from picture to picture.
float turned_offset(ivec2 pixel) {
    vec2 at = vec2(pixel & 1023);
    return fract(fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))) + volume_now.turn);
}

vec4 march(vec3 from, vec3 along, vec2 range, ivec2 pixel, float step_m) {
    vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
    float way = range.y - range.x;
    int count = int(ceil(way / step_m));
#if VOLUME_METHOD == VOLUME_METHOD_JITTERED
    float offset = turned_offset(pixel);
#elif VOLUME_METHOD == VOLUME_METHOD_SUM
    float offset = 0.0;
#else
    float offset = 0.5;
#endif
#if VOLUME_METHOD == VOLUME_METHOD_TRAPEZIUM || VOLUME_METHOD == VOLUME_METHOD_PREINTEGRATED
    float before = density_at(from + range.x * along);
    vec4 before_looks = classified(before);
#endif
#if VOLUME_METHOD == VOLUME_METHOD_SKIPPING
    float known_to = -1.0;  // the block at the sample before ends there
    vec3 speed = voxels_a_metre(along), first = to_texture(from + range.x * along) * volume_now.size;
#endif
    for (int i = 0; i < count; ++i) {
        float begins = float(i) * step_m, length_m = min(step_m, way - begins);
        vec3 position = from + (range.x + begins + offset * length_m) * along;
#if VOLUME_METHOD == VOLUME_METHOD_TRAPEZIUM
        // Extinctions have a mean, opacities do not; and each end colours as far as it is opaque.
        float after = density_at(from + (range.x + begins + length_m) * along);
        vec4 after_looks = classified(after);
        float both = before_looks.a + after_looks.a;
        vec4 looks = vec4(both > 0.0 ? (before_looks.rgb * before_looks.a + after_looks.rgb * after_looks.a) / both : vec3(0.0),
                          1.0 - sqrt(max((1.0 - before_looks.a) * (1.0 - after_looks.a), 0.0)));
        before_looks = after_looks;
#elif VOLUME_METHOD == VOLUME_METHOD_PREINTEGRATED
        float after = density_at(from + (range.x + begins + length_m) * along);
        const float texels = float(textureSize(volume_preintegrated, 0).x);
        vec4 looks = textureLod(volume_preintegrated, (vec2(before, after) * (texels - 1.0) + 0.5) / texels, 0.0);
        if (looks.a > 0.0) looks.rgb /= looks.a;
        before = after;
#else
        vec4 looks = classified(density_at(position));
#endif
        if (looks.a <= 0.0) {
#if VOLUME_METHOD == VOLUME_METHOD_SKIPPING
            // Blocks are read only after an empty sample, so that dense regions pay nothing. The next sample lies
            // behind all empty blocks, at its position without skipping.
            float at = begins + offset * length_m;
            int next = i;
            for (bool empty = at > known_to; empty;) {
                known_to = block_leaves(first + at * speed, speed, at, empty);
                if (!empty) break;
                next = max(next + 1, int(ceil(known_to / step_m - 0.5)));
                if (next >= count) break;
                begins = float(next) * step_m;
                at = begins + offset * min(step_m, way - begins);
            }
            i = max(i, next - 1);
#endif
            continue;
        }
#if VOLUME_METHOD == VOLUME_METHOD_SUM
        float opacity = min(looks.a * length_m / REFERENCE_M, 1.0);  // as many of them as fit: right for thin steps alone
#elif VOLUME_METHOD == VOLUME_METHOD_PREINTEGRATED
        float opacity = correct_opacity(looks.a, length_m / step_m);  // the table is for whole steps
#else
        float opacity = correct_opacity(looks.a, length_m / REFERENCE_M);
#endif
        sum = composite_front_to_back(sum, radiance_at(position, along, looks.rgb), opacity);
        if (is_finished(sum.a, volume_now.brightest, volume.threshold)) break;
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec3 ray = ray_through(volume_now.rays, vec2(pixel) + 0.5), from = volume_now.rays.eye;
    float stretch = length(ray), stored = texelFetch(depth, pixel, 0).r;
    vec3 along = ray / stretch;
    vec2 range = volume_range(from, along);
    bool enters = range.x > 0.0;
    if (stored > 0.0) range.y = min(range.y, stretch * distance_along_view(volume_now.rays, stored));
    vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
#if VOLUME_SCATTERING == VOLUME_SCATTERING_WALK
    if (range.y > range.x) sum = walks(from, along, range, pixel);
#elif VOLUME_METHOD == VOLUME_METHOD_EXACT
    if (range.y > range.x) sum = march_exact(from, along, range, volume_now.step_m, volume.truth_samples);
#else
    if (range.y > range.x) sum = march(from, along, range, pixel, volume_now.step_m);
#endif
#if VOLUME_METHOD == VOLUME_METHOD_JITTERED || VOLUME_SCATTERING == VOLUME_SCATTERING_WALK
    if (volume_now.history > 0.0) sum = mix(imageLoad(marched, pixel), sum, 1.0 / (volume_now.history + 1.0));
    imageStore(marched, pixel, sum);
#endif
#if VOLUME_SHOW == VOLUME_SHOW_ERROR
    // Sixteen times the difference from four steps a voxel.
    float fine = 2.0 / (4.0 * max(volume_now.size.x, max(volume_now.size.y, volume_now.size.z)));
    vec4 right = range.y > range.x ? march(from, along, range, pixel, fine) : vec4(0.0, 0.0, 0.0, 1.0);
    imageStore(result, pixel, vec4(16.0 * abs(sum.rgb - right.rgb), 1.0));
    return;
#endif
    vec4 behind = imageLoad(result, pixel);
    vec3 light = sum.rgb + sum.a * behind.rgb;
#if VOLUME_SHELL
    if (enters && range.y > range.x && volume_now.radius_m > 0.0) light = shell_over(light, from + range.x * along, along);
#endif
#if VOLUME_SHOW == VOLUME_SHOW_BLOCKS
    if (range.y > range.x) light = 0.5 * light + block_edges(from, along, range);
#elif VOLUME_SHOW == VOLUME_SHOW_NOISE
    light = noise_phases(vec2(pixel), vec2(imageSize(result)));
#endif
    imageStore(result, pixel, vec4(min(light, LARGEST_HALF), behind.a));
}
