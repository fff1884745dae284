// How long lines and staircases are, without passes that double: lines from words of edges, staircases step by step.
#define WORK_ACCESS readonly
#include "13_mlaa/diagonal_bits.glsl"
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/line_scan.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(scalar) uniform MlaaBlock { int reach; } mlaa;
layout(r32ui) writeonly uniform uimage2D lengths;

uint scanned(int at, int line, bool horizontal) {
    return scan_back(at, line, horizontal, mlaa.reach) | scan_ahead(at, line, horizontal, mlaa.reach) << 8;
}

#ifdef DIAGONALS
layout(r32ui) writeonly uniform uimage2D staircases;

uint walked(ivec2 pixel, int way) {
    if (!is_step(pixel, way)) return 0u;
    uint back = 1u, ahead = 1u, reach = uint(mlaa.reach);
    ivec2 along = ivec2(way, 1);
    for (ivec2 at = pixel; back < reach && follows_before(at, way); at -= along) ++back;
    for (ivec2 at = pixel; ahead < reach && follows_after(at, way); at += along) ++ahead;
    return back | ahead << 8;
}
#endif

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        uint word = 0u;
        if (edge_below(pixel)) word |= scanned(pixel.x, pixel.y, true) << back_below;
        if (edge_right(pixel)) word |= scanned(pixel.y, pixel.x, false) << back_right;
        imageStore(lengths, pixel, uvec4(word));
#ifdef DIAGONALS
        imageStore(staircases, pixel, uvec4(walked(pixel, 1) << back_falling | walked(pixel, -1) << back_rising));
#endif
    }
}
