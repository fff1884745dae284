// The steps of staircases, and whether the next one follows.
#define WORK_ACCESS readonly
#include "13_mlaa/diagonal_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) writeonly uniform uimage2D into;

// `way`: 1 falling, -1 rising. A step is an edge below a pixel with an edge across before or after it.
uint linked(ivec2 pixel, int way) {
    bool before = edge_before(pixel, way), after = edge_after(pixel, way);
    if (!edge_below(pixel) || !(before || after)) return 0u;
    ivec2 along = ivec2(way, 1);
    return (before && edge_below(pixel - along) ? 2u : 1u) | (after && edge_below(pixel + along) ? 2u : 1u) << 8;
}

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        uint word = linked(pixel, 1) << back_falling | linked(pixel, -1) << back_rising;
        if (word != 0u) imageStore(into, pixel, uvec4(word));
    }
}
