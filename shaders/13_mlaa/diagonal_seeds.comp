// The steps of staircases, and whether the next one follows.
#define WORK_ACCESS readonly
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) writeonly uniform uimage2D into;

// `way`: 1 falling, -1 rising.
uint linked(ivec2 pixel, int way) {
    if (!is_step(pixel, way)) return 0u;
    return (follows_before(pixel, way) ? 2u : 1u) | (follows_after(pixel, way) ? 2u : 1u) << 8;
}

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        imageStore(into, pixel, uvec4(linked(pixel, 1) << back_falling | linked(pixel, -1) << back_rising));
    }
}
