// Solution of 16.skip_empty.
#include "16_volume/block_voxels.glsl"

void skip_empty(ivec3 block) {
    int edge = BLOCK_VOXELS + 2 * border, count = edge * edge * edge;
    ivec3 first = block * BLOCK_VOXELS - border, last = textureSize(voxels, 0) - 1;
    vec2 range = vec2(65504.0, 0.0);
    for (int i = int(gl_LocalInvocationIndex); i < count; i += 64) {
        ivec3 at = first + ivec3(i % edge, i / edge % edge, i / (edge * edge));
        float density = texelFetch(voxels, clamp(at, ivec3(0), last), 0).r;
        density = density > 0.0 ? density : 0.0;
        range = vec2(min(range.x, density), max(range.y, density));
    }
    thread_ranges[gl_LocalInvocationIndex] = range;
    barrier();
    for (uint half_count = 32u; half_count > 0u; half_count /= 2u) {
        if (gl_LocalInvocationIndex < half_count) {
            vec2 mine = thread_ranges[gl_LocalInvocationIndex], other = thread_ranges[gl_LocalInvocationIndex + half_count];
            thread_ranges[gl_LocalInvocationIndex] = vec2(min(mine.x, other.x), max(mine.y, other.y));
        }
        barrier();
    }
    if (gl_LocalInvocationIndex == 0u) imageStore(ranges, block, vec4(thread_ranges[0], 0.0, 0.0));
}
