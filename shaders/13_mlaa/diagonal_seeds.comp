// The steps of staircases.
#define WORK_ACCESS readonly
#include "13_mlaa/diagonal_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) writeonly uniform uimage2D into;

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        if (!edge_below(pixel)) continue;
        uint seeds = 0u;
        if (edge_right(pixel + ivec2(0, 1))) seeds |= seed_of_falling;
        if (edge_right(pixel + ivec2(-1, 1))) seeds |= seed_of_rising;
        imageStore(into, pixel, uvec4(seeds));
    }
}
