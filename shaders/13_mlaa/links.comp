// Which pixels' edges are one line: the next pixel has such an edge as well, and there is no crossing between the two.
#define WORK_ACCESS readonly
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_words.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) writeonly uniform uimage2D into;

// Where four edges meet, two corners touch: the apparent line consists of two outlines.
bool is_crossing(ivec2 pixel, ivec2 across, bool horizontal) {
    return horizontal ? edge_right(pixel) && edge_right(pixel + across) : edge_below(pixel) && edge_below(pixel + across);
}

uint linked(ivec2 pixel, bool horizontal) {
    ivec2 along = ivec2(horizontal, !horizontal), across = ivec2(!horizontal, horizontal);
    bool back = horizontal ? edge_below(pixel - along) : edge_right(pixel - along);
    bool ahead = horizontal ? edge_below(pixel + along) : edge_right(pixel + along);
    back = back && !is_crossing(pixel - along, across, horizontal);
    ahead = ahead && !is_crossing(pixel, across, horizontal);
    return (back ? 2u : 1u) | (ahead ? 2u : 1u) << 8;
}

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        uint word = 0u;
        if (edge_below(pixel)) word |= linked(pixel, true) << back_below;
        if (edge_right(pixel)) word |= linked(pixel, false) << back_right;
        imageStore(into, pixel, uvec4(word));
    }
}
